// The pieces that boundaries are made of, and where a sphere touches one.
#pragma once

#include <array>
#include <cstdint>
#include <variant>

#include "core/vec3.hpp"

namespace packstone::engine {

/// How a piece of a boundary meets a sphere's centre: along the shortest way from one to the other.
struct Touch {
  Vec3 normal = Vec3::Zero();  ///< unit vector from the boundary to the centre
  double distance = 0;         ///< along it [m]; below 0 where the centre has gone through
  /// How the normal turns as the centre moves across it by u: turning u + turning_along (u . direction) direction
  /// [1/m].
  double turning = 0;
  double turning_along = 0;
  Vec3 direction = Vec3::Zero();  ///< unit vector
};

/// A half space's surface.
struct PlanePiece {
  Vec3 normal;    ///< unit vector to the particles' side
  double height;  ///< of its points along the normal [m]
};

/// The part of space on one side of a plane, which bounds where another piece is the nearest.
struct HalfSpace {
  Vec3 normal;   ///< unit vector
  double limit;  ///< [m]

  /// How far a point lies beyond it [m].
  double beyond(const Vec3& p) const { return normal.dot(p) - limit; }
};

/// A flat triangle with two sides; touched where the centre lies above or below it.
struct TrianglePiece {
  std::array<Vec3, 3> corner;       ///< [m]
  Vec3 normal;                      ///< unit vector
  std::array<HalfSpace, 3> inside;  ///< across its sides, away from it
};

/// A straight edge; touched where no triangle at it is.
struct EdgePiece {
  Vec3 start;                ///< [m]
  Vec3 direction;            ///< unit vector
  double length;             ///< [m]
  std::int32_t first, last;  ///< of Shape::slabs: those of the triangles at it
};

/// A corner; touched where no edge at it is.
struct CornerPiece {
  Vec3 point;                ///< [m]
  std::int32_t first, last;  ///< of Shape::slabs: across its end of each edge at it, along the edge
};

/// A frustum, tube, ring or disc: a straight line turned about an axis; it has two sides.
struct RoundPiece {
  Vec3 origin, axis;                  ///< [m]; unit vector
  double radius, height;              ///< where the line begins [m]
  double along_radius, along_height;  ///< unit vector of the line in the plane through the axis
  double length;                      ///< of the line [m]
};

/// A circle about an axis: where round pieces meet or end; touched where none of them is.
struct RimPiece {
  Vec3 origin, axis;
  double radius, height;                       ///< [m]
  std::array<std::array<double, 2>, 2> lines;  ///< unit vectors (radius, height) away from it along the pieces
  int count;                                   ///< of lines
};

using Piece = std::variant<PlanePiece, TrianglePiece, EdgePiece, CornerPiece, RoundPiece, RimPiece>;

}  // namespace packstone::engine
