// Spheres at random places with all that a file can carry.
#pragma once

#include "core/random.hpp"
#include "core/snapshot.hpp"

namespace packstone::testing {

/// Two groups, velocities and forces; places and sizes use all digits of a double. Ids ascend from 5 in steps of 3.
inline Snapshot random_packing(std::size_t count) {
  Snapshot s;
  s.time = 0.125;
  s.step = 4711;
  s.domain = {Vec3(-1, 0, 0), Vec3(1, 1, 3), {true, true, false}};
  s.groups = {{"light", "light", 1200}, {"heavy", "heavy", 7800}};
  s.material_names = {"light", "heavy"};
  for (const char* name : {"velocity", "angular_velocity", "force"}) s.fields[name].components = 3;
  for (std::size_t i = 0; i < count; ++i) {
    Random r(7, RandomStream::filling_position, i);
    s.position.emplace_back(r.uniform(-1, 1), r.uniform(), r.uniform(0, 3));
    s.radius.push_back(r.uniform(0.01, 0.02));
    s.id.push_back(static_cast<std::int64_t>(5 + 3 * i));
    s.type.push_back(static_cast<std::int32_t>(i % 2));
    for (auto& [name, field] : s.fields) {
      for (int k = 0; k < 3; ++k) field.values.push_back(r.uniform(-1, 1));
    }
  }
  s.material = s.type;
  return s;
}

}  // namespace packstone::testing
