#include "engine/boundary/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/run_verdict.hpp"

namespace packstone::engine {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

Motion::Motion(const Scene& scene, std::size_t boundary, const Vec3& point)
    : spec_(scene.boundaries[boundary].motion),
      name_(scene.boundaries[boundary].name),
      path_(fmt::format("boundary[{}].motion", boundary)),
      start_(spec_.stage ? never : spec_.start),
      end_(spec_.stage ? never : spec_.end.value_or(never)),
      centre_(spec_.rotation_centre.value_or(point)),
      axis_(spec_.rotation_axis.normalized()) {
  for (const std::string& text : spec_.displacement) {
    displacement_.push_back(formula_of(scene, path_ + ".displacement", text, {"t"}));
  }
  if (spec_.rotates) angle_.emplace(formula_of(scene, path_ + ".rotation.angle", spec_.angle, {"t"}));
  if (spec_.free) force_.emplace(formula_of(scene, path_ + ".free.force", spec_.force, {"t"}));
}

void Motion::begin_stage(const std::string& stage, double time) {
  if (!spec_.stage) return;
  if (stage == *spec_.stage) {
    start_ = time + spec_.start;
    end_ = spec_.end ? time + *spec_.end : never;
  } else {
    end_ = std::min(end_, time);  // at rest where its own stage has left it
  }
}

double Motion::local(double time) const { return start_ < end_ ? std::clamp(time, start_, end_) - start_ : 0; }

double Motion::value(const Formula& formula, double t, const char* key) const {
  const double result = formula({t});
  if (std::isfinite(result)) return result;
  RunVerdict v{FailureKind::formula_not_a_number};
  v.boundaries = {name_};
  v.quantity = fmt::format("motion.{}", key);
  v.value = result;
  v.what = fmt::format("boundary {}: motion.{} = \"{}\" is not a number {:.6g} s after its start", name_, key,
                       formula.text(), t);
  v.advice = "change the formula, or end the motion before";
  v.remedies = {{fmt::format("{}.{}", path_, key)}, {path_ + ".end"}};
  throw RunFailure(v);
}

Vec3 Motion::shift(double t) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < displacement_.size(); ++k) {
    sum[static_cast<Eigen::Index>(k)] = value(displacement_[k], t, "displacement");
  }
  if (spec_.vibrates) {
    const double swing = std::sin(2 * std::numbers::pi * spec_.frequency * t + spec_.phase) - std::sin(spec_.phase);
    sum += swing * spec_.amplitude;
  }
  return sum;
}

double Motion::angle(double t) const { return angle_ ? value(*angle_, t, "rotation.angle") : 0; }

Pose Motion::at(double time) const {
  const double t = local(time);
  return {centre_, shift(t), Eigen::AngleAxisd(angle(t), axis_).toRotationMatrix()};
}

PoseRate Motion::rate(double before, double after) const {
  const double t = local(before), u = local(after), dt = after - before;
  return {(shift(u) - shift(t)) / dt, (angle(u) - angle(t)) / dt * axis_};
}

double Motion::force(double time) const { return value(*force_, local(time), "free.force"); }

}  // namespace packstone::engine
