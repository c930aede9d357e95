#include "engine/gravity.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

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
  throw RunError(fmt::format("t = {:.6g} s: gravity.formula is not a number; change it, or set gravity.end", time));
}

}  // namespace packstone::engine
