#include "engine/dynamics/particles.hpp"

#include <limits>
#include <utility>

#include "engine/threads.hpp"

namespace packstone::engine {

namespace {

/// Gathers into the store to spare and swaps the two, so that nothing is allocated once sizes have settled.
template <class Array>
void gather(Array& values, Array& spare, const std::vector<std::int32_t>& from,
            const typename Array::value_type& empty) {
  spare.resize(from.size());
  const auto slots = static_cast<std::ptrdiff_t>(from.size());
#pragma omp parallel for schedule(static) num_threads(useful_threads(from.size()))
  for (std::ptrdiff_t s = 0; s < slots; ++s) {
    spare[s] = from[s] == Particles::no_particle ? empty : values[from[s]];
  }
  std::swap(values, spare);
}

}  // namespace

void Particles::reorder(const std::vector<std::int32_t>& from) {
  gather(now.rows, next.rows, from, Row{});
  if (turns()) {
    gather(now.spins, next.spins, from, Spin{});
    gather(inverse_inertia, spare_numbers, from, 0.0);
  }
  for (VectorArray* vectors : {&half_velocity, &half_angular_velocity}) {
    if (vectors->empty()) continue;
    for (auto* component : {&vectors->x, &vectors->y, &vectors->z}) gather(*component, spare_numbers, from, 0.0);
  }
  gather(mass, spare_numbers, from, 0.0);
  gather(id, spare_integers, from, no_particle);
  gather(type, spare_integers, from, 0);
  gather(material, spare_integers, from, 0);
  now.rows[nobody()].position.setConstant(std::numeric_limits<double>::quiet_NaN());
  next.rows.resize(now.rows.size());
  next.rows[nobody()] = now.rows[nobody()];
  next.spins.resize(now.spins.size());
}

}  // namespace packstone::engine
