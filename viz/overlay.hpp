// What is drawn among the particles: contacts and force chains as tubes, vectors as arrows, paths that particles came.
#pragma once

#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone::viz {

/// A straight piece with a value that its size and colour show.
struct Segment {
  Vec3 from;     ///< [m]
  Vec3 way;      ///< to the other end, which may lie over a periodic side [m]; of an arrow its value [SI]
  double value;  ///< SI, not negative
};

/// Segments of one kind, on one scale.
struct SegmentSet {
  std::string title;  ///< of the legend, with the unit
  std::vector<Segment> segments;

  /// The value that the given share of the segments does not exceed, 1 for the largest; 0 where there are none.
  double quantile(double share) const;
};

/// Where a particle was, the oldest place first.
struct Path {
  std::int64_t id;
  std::vector<Vec3> points;  ///< [m]
};

/// What a scale of its own reaches to: forces have a long tail, which would leave most tubes thin; arrows' lengths do
/// not end.
inline constexpr double link_quantile = 0.99, arrow_quantile = 1;

struct Overlay {
  SegmentSet links;   ///< tubes
  SegmentSet arrows;  ///< from the particles' centres
  std::vector<Path> paths;
};

/// Every stored contact, by the magnitude of its force: from centre to centre, at a wall from the centre to the point.
/// Contacts whose particles the snapshot lacks are left out. Throws InputError when it has no contacts.
SegmentSet contact_links(const Snapshot& snapshot);

/// A field of vectors, or "acceleration" from the field "force" and the masses. Throws InputError that lists the fields
/// there are.
SegmentSet arrows_of(const Snapshot& snapshot, const std::string& name);

/// A way from a point, cut where it crosses periodic sides, each piece inside the domain: (from, to) [m].
std::vector<std::pair<Vec3, Vec3>> pieces_inside(const Domain& domain, const Vec3& from, const Vec3& way);

}  // namespace packstone::viz
