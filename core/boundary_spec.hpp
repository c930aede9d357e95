// What a [[boundary]] of the scene says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/vec3.hpp"

namespace packstone {

enum class BoundaryKind { plane, box, cylinder, cone, funnel, surface, polygons, mesh };

/// On which side of a boundary particles are filled in. Where it is both, a filling only keeps clear of the boundary.
enum class Side { automatic, inside, outside, both };

/// Ends of a cylinder, cone or funnel, along its axis.
enum End { bottom_end, top_end };

/// How a boundary moves: what is given of it adds up. t in formulas is the time since `start` [s].
struct MotionSpec {
  bool present = false;
  std::optional<std::string> stage;  ///< in which it moves; start and end then count from that stage's beginning
  double start = 0;                  ///< [s]
  std::optional<double> end;         ///< from when on it stays where it is [s]

  std::vector<std::string> displacement;  ///< three formulas in t [m]; empty: none

  bool rotates = false;
  Vec3 rotation_axis = Vec3::UnitZ();
  std::optional<Vec3> rotation_centre;  ///< [m]; the boundary's point unless given
  std::string angle;                    ///< formula in t [rad]

  bool vibrates = false;
  Vec3 amplitude = Vec3::Zero();  ///< [m]
  double frequency = 0;           ///< [Hz]
  double phase = 0;               ///< [rad]

  bool free = false;
  Vec3 free_axis = Vec3::UnitZ();
  double mass = 0;              ///< [kg]
  std::string force = "0";      ///< along the axis, beside gravity; formula in t [N]
  std::optional<double> limit;  ///< the farthest it goes along the axis [m]
};

struct BoundarySpec {
  std::string name;
  BoundaryKind kind = BoundaryKind::plane;
  std::string material;             ///< the first material unless given
  Side side = Side::automatic;      ///< automatic no longer once the scene has been read
  double from = 0;                  ///< since when it is there [s]
  std::optional<double> until;      ///< [s]
  std::vector<std::string> stages;  ///< in which it is there; empty: in all

  std::optional<Vec3> point;                ///< [m]
  std::optional<Vec3> normal;               ///< of a plane, to the particles' side
  std::optional<Vec3> axis;                 ///< of a cylinder, cone or funnel, from its lower end to its upper
  std::optional<double> radius;             ///< [m]
  std::optional<double> top_radius;         ///< [m]
  std::optional<double> outlet_radius;      ///< [m]
  std::optional<double> length;             ///< [m]; a cylinder without one has no ends
  std::optional<double> cone_length;        ///< [m]
  std::optional<double> tube_length;        ///< [m]
  std::vector<int> closed;                  ///< End values
  std::optional<Vec3> min;                  ///< of a box [m]
  std::optional<Vec3> max;                  ///< [m]
  std::vector<int> open;                    ///< Face values
  std::optional<std::string> formula;       ///< z = f(x, y) [m]
  std::optional<std::string> grid;          ///< file of points x, y, z
  std::optional<double> tolerance;          ///< of a surface's triangles [m]
  std::vector<std::vector<Vec3>> polygons;  ///< corners of each [m]
  std::optional<std::string> path;          ///< of a mesh, from the root
  std::optional<double> scale;              ///< of the mesh's numbers
  std::optional<Vec3> offset;               ///< of the mesh's origin, after scaling [m]

  MotionSpec motion;
};

}  // namespace packstone
