// How boundaries move.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/archive.hpp"
#include "core/scene.hpp"
#include "engine/formula.hpp"

namespace packstone::engine {

/// Where a body is: x in the scene's frame goes to centre + shift + turn (x - centre).
struct Pose {
  Vec3 centre = Vec3::Zero();  ///< of turning, in the scene's frame [m]
  Vec3 shift = Vec3::Zero();   ///< [m]
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();

  void archive(Archive& a) { a(centre, shift, turn); }

  Vec3 operator()(const Vec3& x) const { return centre + shift + turn * (x - centre); }
  /// The way back.
  Vec3 inverse(const Vec3& x) const { return centre + turn.transpose() * (x - centre - shift); }
};

/// How fast it goes.
struct PoseRate {
  Vec3 velocity = Vec3::Zero();          ///< of the centre [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]

  void archive(Archive& a) { a(velocity, angular_velocity); }

  Vec3 at(const Vec3& x, const Pose& pose) const {
    return velocity + angular_velocity.cross(x - pose.centre - pose.shift);
  }
};

/// The motion that formulas give.
class Motion {
 public:
  /// point: of the boundary, about which it turns unless the scene says otherwise [m]. Throws InputError located in
  /// the scene.
  Motion(const Scene& scene, std::size_t boundary, const Vec3& point);

  /// Tells which stage begins, and when [s].
  void begin_stage(const std::string& stage, double time);

  /// What its stages have set.
  void archive(Archive& a) { a(start_, end_); }

  Pose at(double time) const;
  /// Rate over the time between two instants [s].
  PoseRate rate(double before, double after) const;
  /// The force along the axis of a free body [N].
  double force(double time) const;
  /// Whether t is within the motion's time.
  bool moves(double time) const { return time >= start_ && time < end_; }

 private:
  double local(double time) const;
  Vec3 shift(double t) const;
  double angle(double t) const;
  double value(const Formula& formula, double t, const char* key) const;

  MotionSpec spec_;
  std::string name_;
  std::string path_;    ///< in the scene
  double start_, end_;  ///< [s]; not yet known where its stage is still to come
  Vec3 centre_, axis_;
  std::vector<Formula> displacement_;
  std::optional<Formula> angle_, force_;
};

}  // namespace packstone::engine
