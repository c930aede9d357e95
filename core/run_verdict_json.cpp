#include "core/run_verdict_json.hpp"

#include <limits>

namespace packstone {

using nlohmann::ordered_json;

namespace {

ordered_json particles_json(const std::vector<NamedParticle>& particles) {
  ordered_json list = ordered_json::array();
  for (const NamedParticle& p : particles) list.push_back({{"id", p.id}, {"group", p.group}});
  return list;
}

std::vector<NamedParticle> particles_of(const ordered_json& list) {
  std::vector<NamedParticle> particles;
  for (const auto& p : list) particles.push_back({p.at("id"), p.at("group")});
  return particles;
}

/// JSON has no infinite numbers: null stands for one, and for what is not a number.
double number_of(const ordered_json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

}  // namespace

ordered_json to_json(const RunVerdict& v) {
  ordered_json changes = ordered_json::array();
  for (const Remedy& r : v.remedies) {
    changes.push_back({{"key", r.key}, {"to", r.value.empty() ? ordered_json(nullptr) : ordered_json(r.value)}});
  }
  return {{"kind", to_string(v.kind)},
          {"time", v.time ? ordered_json(*v.time) : ordered_json(nullptr)},
          {"step", v.step ? ordered_json(*v.step) : ordered_json(nullptr)},
          {"particles", particles_json(v.particles)},
          {"touching", particles_json(v.touching)},
          {"boundaries", v.boundaries},
          {"place", v.place ? ordered_json{(*v.place)[0], (*v.place)[1], (*v.place)[2]} : ordered_json(nullptr)},
          {"quantity", v.quantity},
          {"value", v.value},
          {"limit", v.limit},
          {"unit", v.unit},
          {"what", v.what},
          {"cause", v.cause},
          {"advice", v.advice},
          {"change", changes}};
}

RunVerdict run_verdict_from(const ordered_json& json) {
  RunVerdict v;
  v.kind = failure_kind_named(json.at("kind"));
  if (!json.at("time").is_null()) v.time = json.at("time").get<double>();
  if (!json.at("step").is_null()) v.step = json.at("step").get<std::int64_t>();
  v.particles = particles_of(json.at("particles"));
  v.touching = particles_of(json.at("touching"));
  v.boundaries = json.at("boundaries").get<std::vector<std::string>>();
  if (const auto& place = json.at("place"); !place.is_null()) {
    v.place = Vec3(number_of(place.at(0)), number_of(place.at(1)), number_of(place.at(2)));
  }
  v.quantity = json.at("quantity");
  v.value = number_of(json.at("value"));
  v.limit = number_of(json.at("limit"));
  v.unit = json.at("unit");
  v.what = json.at("what");
  v.cause = json.at("cause");
  v.advice = json.at("advice");
  for (const auto& change : json.at("change")) {
    const auto& to = change.at("to");
    v.remedies.push_back({change.at("key"), to.is_null() ? "" : to.get<std::string>()});
  }
  return v;
}

}  // namespace packstone
