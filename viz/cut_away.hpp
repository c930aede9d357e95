// A part of a packing left out of its picture, so that one sees inside.
#pragma once

#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone::viz {

/// All points on one side of a plane across an axis.
struct HalfSpace {
  int axis = 0;       ///< 0 x, 1 y, 2 z
  bool above = true;  ///< the coordinate is larger than place
  double place = 0;   ///< [m]

  bool holds(const Vec3& point) const { return above ? point[axis] > place : point[axis] < place; }
};

/// What lies in all of the half spaces is cut away; nothing where there are none.
using CutAway = std::vector<HalfSpace>;

/// From "x>0.3" or "x > 300 mm, y < 0.2 m", the latter a corner. Throws InputError otherwise.
CutAway cut_from_text(const std::string& text);

/// Whether a particle with its centre there is left out.
bool is_cut_away(const CutAway& cut, const Vec3& centre);

/// Whether all particles with their centres in the box are left out.
bool is_cut_away(const CutAway& cut, const Region& box);

/// How much of a sphere lies in what is cut away.
enum class CutShare { none, part, all };
CutShare cut_share(const CutAway& cut, const Vec3& centre, double radius);

}  // namespace packstone::viz
