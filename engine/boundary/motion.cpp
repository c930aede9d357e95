#include "engine/boundary/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone::engine {

namespace {

Formula formula_of(const Scene& scene, const std::string& path, const std::string& text) {
  try {
    return Formula(text, {"t"});
  } catch (const InputError& error) {
    scene.fail(path, error.what());
  }
}

}  // namespace

Motion::Motion(const Scene& scene, std::size_t boundary, const Vec3& point)
    : spec_(scene.boundaries[boundary].motion),
      name_(scene.boundaries[boundary].name),
      end_(spec_.end.value_or(std::numeric_limits<double>::infinity())),
      centre_(spec_.rotation_centre.value_or(point)),
      axis_(spec_.rotation_axis.normalized()) {
  const std::string path = fmt::format("boundary[{}].motion", boundary);
  for (const std::string& text : spec_.displacement) {
    displacement_.push_back(formula_of(scene, path + ".displacement", text));
  }
  if (spec_.rotates) angle_.emplace(formula_of(scene, path + ".rotation.angle", spec_.angle));
  if (spec_.free) force_.emplace(formula_of(scene, path + ".free.force", spec_.force));
}

double Motion::local(double time) const { return std::clamp(time, spec_.start, end_) - spec_.start; }

double Motion::value(const Formula& formula, double t, const char* key) const {
  const double result = formula({t});
  if (std::isfinite(result)) return result;
  throw RunError(
      fmt::format("boundary {}: motion.{} = \"{}\" is not a number {:.6g} s after its start; change the "
                  "formula, or end the motion before",
                  name_, key, formula.text(), t));
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
