#include "engine/gravity.hpp"

#include <limits>

#include <fmt/format.h>

#include "core/run_verdict.hpp"

namespace packstone::engine {

Gravity::Gravity(const Scene& scene) : spec_(scene.gravity) {
  for (const std::string& text : spec_.formula) formula_.push_back(formula_of(scene, "gravity.formula", text, {"t"}));
}

bool Gravity::acts(double time) const {
  return spec_.present && time >= spec_.start && (!spec_.end || time < *spec_.end);
}

Vec3 Gravity::at(double time) const {
  if (!acts(time)) return Vec3::Zero();
  if (formula_.empty()) return spec_.acceleration;
  const Vec3 value(formula_[0]({time}), formula_[1]({time}), formula_[2]({time}));
  if (value.allFinite()) return value;
  RunVerdict v{FailureKind::formula_not_a_number};
  v.time = time;
  v.quantity = "gravity.formula";
  v.value = std::numeric_limits<double>::quiet_NaN();
  v.unit = "m/s2";
  v.what = "gravity.formula is not a number";
  v.advice = "change it, or set gravity.end";
  v.remedies = {{"gravity.formula"}, {"gravity.end", fmt::format("{:.6g} s", time)}};
  throw RunFailure(v);
}

}  // namespace packstone::engine
