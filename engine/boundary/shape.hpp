// The surface of a boundary, in the frame in which the scene gives it: pieces, and a tree to find those near a point.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/boundary_spec.hpp"
#include "core/snapshot.hpp"
#include "engine/boundary/box_tree.hpp"
#include "engine/boundary/piece.hpp"

namespace packstone::engine {

class Shape {
 public:
  /// Where the sphere about p touches a piece; false where another piece is nearer or the piece does not face it.
  /// reach: the sphere's radius [m]. on_side: 1 or -1, on which side of a piece with two the sphere is; it changes only
  /// while the two are apart, so that a centre pressed through is pressed back.
  bool touch(std::int32_t piece, const Vec3& p, double reach, std::int8_t& on_side, Touch& at) const;

  /// Which side of a piece a point is on: 1 or -1.
  std::int8_t side_of(std::int32_t piece, const Vec3& p) const;

  /// Distance of a point from a piece, as if no other were there; signed from a plane [m].
  double distance(std::int32_t piece, const Vec3& p) const;

  /// visit(piece) for all that are no farther than reach [m].
  template <class Visit>
  void for_each_near(const Vec3& p, double reach, const Visit& visit) const {
    tree_.for_each_near(p, reach, [&](std::int32_t piece) {
      if (distance(piece, p) <= reach) visit(piece);
    });
  }

  /// Whether a straight line from p down meets an odd number of triangles: p is within a closed surface, or above one
  /// that covers the ground.
  bool covered(const Vec3& p) const;

  /// Whether a filling may put a particle's centre there.
  bool allows(const Vec3& p) const;

  bool is_plane() const { return pieces.size() == 1 && std::holds_alternative<PlanePiece>(pieces.front()); }

  /// Of the box about it that stands along the axes [m]; a plane's is infinite.
  const Extent& extent() const { return tree_.extent(); }

  /// To be called when all pieces are there.
  void finish();

  std::vector<Piece> pieces;
  std::vector<HalfSpace> slabs;
  Side side = Side::both;  ///< that fillings may use
  /// Whether a point is inside; empty where triangles tell.
  std::function<bool(const Vec3&)> encloses;
  bool repeats = false;   ///< in every image of a periodic domain, rather than going through all of them
  BoundaryRecord record;  ///< how snapshots show it: all but name and kind

 private:
  BoxTree tree_;
};

}  // namespace packstone::engine
