#include "engine/dynamics/particles.hpp"

#include <limits>
#include <utility>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

template <class Array>
void gather(Array& values, const std::vector<std::int32_t>& from, const typename Array::value_type& empty) {
  Array before(from.size(), empty);
  std::swap(before, values);
  const auto slots = static_cast<std::ptrdiff_t>(from.size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(from.size()))
  for (std::ptrdiff_t s = 0; s < slots; ++s) {
    if (from[s] != Particles::no_particle) values[s] = before[from[s]];
  }
}

}  // namespace

void Particles::reorder(const std::vector<std::int32_t>& from) {
  gather(now.rows, from, Row{});
  if (turns()) {
    gather(now.spins, from, Spin{});
    gather(inverse_inertia, from, 0.0);
  }
  for (VectorArray* vectors : {&half_velocity, &half_angular_velocity}) {
    if (vectors == &half_angular_velocity && !turns()) continue;
    for (auto* component : {&vectors->x, &vectors->y, &vectors->z}) gather(*component, from, 0.0);
  }
  gather(mass, from, 0.0);
  gather(id, from, no_particle);
  gather(type, from, 0);
  gather(material, from, 0);
  now.rows[nobody()].position.setConstant(std::numeric_limits<double>::quiet_NaN());
  next.rows.resize(now.rows.size());
  next.rows[nobody()] = now.rows[nobody()];
  next.spins.resize(now.spins.size());
}

}  // namespace packstone::engine
