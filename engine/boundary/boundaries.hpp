// All boundaries of a scene: where they are, how they move, what presses on them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "engine/boundary/motion.hpp"
#include "engine/boundary/shape.hpp"

namespace packstone::engine {

/// What particles do to a boundary at an instant.
struct WallLoad {
  Vec3 force = Vec3::Zero();  ///< on the boundary [N]
  double power = 0;           ///< of the boundary on the particles [W]

  void add(const WallLoad& other) {
    force += other.force;
    power += other.power;
  }
};

class Boundaries {
 public:
  struct Body {
    Shape shape;
    std::int32_t material = 0;
    bool present = true;
    bool moves = false;       ///< ever
    Pose pose;                ///< at the instant
    PoseRate rate;            ///< as contacts see it
    double travelled = 0;     ///< no point of it has gone farther since the start [m]
    double speed = 0;         ///< no point of it is faster [m/s]
    double travel = 0;        ///< of a free body along its axis [m]
    double half_speed = 0;    ///< of a free body along its axis, half a step before the instant [m/s]
    double acceleration = 0;  ///< of a free body at the instant before [m/s2]
    std::optional<Motion> motion;

    Vec3 inside(const Vec3& p) const { return moves ? pose.inverse(p) : p; }
  };

  /// Builds the shapes, files included. Throws InputError located in the scene or the file.
  Boundaries(const Scene& scene, const Domain& domain);

  std::size_t size() const { return bodies_.size(); }
  const Body& operator[](std::size_t k) const { return bodies_[k]; }

  /// visit(image) for p and, of a body that stands in every image of a periodic domain, p's neighbouring images.
  template <class Visit>
  void for_each_image(const Body& body, const Vec3& p, const Visit& visit) const {
    for (int shift = 0; shift < shifts; ++shift) {
      if (shift == no_shift || (body.shape.repeats && along_periodic_axes(shift)))
        visit(p - shift_vector(shift), shift);
    }
  }

  /// Images are numbered by threes along x, y, z.
  static constexpr int shifts = 27, no_shift = 13;
  /// From the body to its image [m].
  Vec3 shift_vector(int shift) const {
    const Vec3 boxes(shift % 3 - 1, shift / 3 % 3 - 1, shift / 9 - 1);
    return boxes.cwiseProduct(domain_.size());
  }

  /// Tells which of the scene's stages begins, and when [s].
  void begin_stage(const std::string& stage, double time);

  /// Brings all to an instant. velocity_lead: as in StepInput. Throws RunFailure where a formula gives no number.
  void go_to(double time, double dt, double velocity_lead);

  /// Moves free bodies on by a step, from the loads of the instant.
  void push(const std::vector<WallLoad>& loads, const Vec3& gravity, double time, double dt);

  /// Whether a filling may put a sphere about p: all that are there now are farther than reach [m].
  bool leave_room(const Vec3& p, double reach) const;

  /// The first plane that a point is behind.
  std::optional<std::size_t> plane_before(const Vec3& p) const;

  /// How they have moved. Throws InputError where a surface has other pieces than when it was written.
  void archive(Archive& a);

  /// As snapshots hold them.
  std::vector<BoundaryRecord> records() const;

 private:
  double farthest_point(const Body& body) const;
  bool is_there(const BoundarySpec& spec, double time) const;
  bool along_periodic_axes(int shift) const;

  std::vector<BoundarySpec> specs_;
  Domain domain_;
  std::vector<Body> bodies_;
  std::string stage_;
};

}  // namespace packstone::engine
