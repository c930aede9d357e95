#include "engine/dynamics/particles.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/simd/scalar.hpp"
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

namespace {

std::array<float, 3> narrowed(const Vec3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace

void Particles::make_compact(const Vec3& period, const Vec3& middle) {
  constexpr double places_in_period = 4294967296.0;  // 2^32
  places.per_metre = places_in_period * period.cwiseInverse();
  places.metres = period / places_in_period;
  for (int axis = 0; axis < 3; ++axis) {
    const double periods = std::nearbyint(middle[axis] / period[axis]);
    places.integer_in_low_word[axis] = 0x1.8p52 - periods * places_in_period;
  }
  for (Kinematics* instant : {&now, &next}) {
    instant->compact_rows.resize(slots());
    instant->compact_spins.resize(turns() ? slots() : 0);
  }
  const auto last = static_cast<std::ptrdiff_t>(slots());
#pragma omp parallel for schedule(static) num_threads(useful_threads(slots()))
  for (std::ptrdiff_t s = 0; s < last; ++s) {
    const Row& row = now.rows[s];
    CompactRow& compact = now.compact_rows[s];
    if (!is_particle(s)) {
      compact = {};
      compact.radius = std::numeric_limits<float>::quiet_NaN();
    } else {
      for (int axis = 0; axis < 3; ++axis) {
        const double sum = simd::fused(row.position[axis], places.per_metre[axis], places.integer_in_low_word[axis]);
        compact.place[axis] = static_cast<std::int32_t>(static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(sum)));
      }
      compact.radius = static_cast<float>(row.radius);
      compact.velocity = narrowed(row.velocity);
      compact.inverse_mass = static_cast<float>(row.inverse_mass);
    }
    if (turns()) now.compact_spins[s].angular_velocity = narrowed(now.spins[s].angular_velocity);
  }
  next.compact_rows[nobody()] = now.compact_rows[nobody()];
}

}  // namespace packstone::engine
