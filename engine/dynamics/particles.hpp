// The particles' state, in slots that follow the neighbour list: neighbours in space lie close in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "core/vec3.hpp"
#include "engine/aligned_vector.hpp"

namespace packstone::engine {

/// Three arrays that together hold one vector a slot.
struct VectorArray {
  AlignedVector<double> x, y, z;

  void resize(std::size_t n) {
    for (auto* component : {&x, &y, &z}) component->resize(n, 0.0);
  }
  bool empty() const { return x.empty(); }
  void archive(Archive& a) { a(x, y, z); }
  Vec3 get(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3& v) {
    x[i] = v[0];
    y[i] = v[1];
    z[i] = v[2];
  }
};

/// What a contact sees of a particle: one cache line.
struct alignas(64) Row {
  static constexpr std::uint32_t doubles = 8, velocity_at = 4;  ///< for reading columns of numbers out of rows
  static constexpr bool solid = true;

  Vec3 position = Vec3::Zero();  ///< [m]; leaves the box along periodic axes until the list is built anew
  double radius = 0;             ///< at full size [m]
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
  double inverse_mass = 0;       ///< at full size [1/kg]
};
static_assert(sizeof(Row) == Row::doubles * sizeof(double));
static_assert(offsetof(Row, velocity) == Row::velocity_at * sizeof(double));

/// How it turns; where anything does.
struct alignas(32) Spin {
  static constexpr std::uint32_t doubles = 4;
  static constexpr bool solid = true;

  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
  double unused = 0;
};
static_assert(sizeof(Spin) == Spin::doubles * sizeof(double));

/// What a contact in single precision sees of a particle: half a cache line.
struct alignas(32) CompactRow {
  static constexpr std::uint32_t words = 8, velocity_at = 4;  ///< for reading columns of words out of rows
  static constexpr bool solid = true;

  std::array<std::int32_t, 3> place = {};  ///< position in steps of Places, modulo 2^32
  float radius = 0;  ///< at full size [m]; not a number in the slot of nobody, so that nothing touches
  std::array<float, 3> velocity = {};  ///< [m/s]
  float inverse_mass = 0;              ///< at full size [1/kg]
};
static_assert(sizeof(CompactRow) == CompactRow::words * sizeof(float));
static_assert(offsetof(CompactRow, velocity) == CompactRow::velocity_at * sizeof(float));

/// How it turns, in single precision.
struct alignas(16) CompactSpin {
  static constexpr std::uint32_t words = 4;
  static constexpr bool solid = true;

  std::array<float, 3> angular_velocity = {};  ///< [rad/s]
  float unused = 0;
};
static_assert(sizeof(CompactSpin) == CompactSpin::words * sizeof(float));

/// The integers that stand for positions: steps of a period / 2^32. The difference of two places, modulo 2^32, is the
/// distance to the nearest image where the period is the side of a periodic box, or goes into it a whole number of
/// times; it is right as long as neighbours are less than half a period apart.
struct Places {
  Vec3 per_metre = Vec3::Zero(), metres = Vec3::Zero();
  /// Added to this, x times per_metre leaves its nearest integer, modulo 2^32, in the low word of the sum: 1.5 * 2^52
  /// less a multiple of 2^32 that brings the middle of the box near to 0.
  Vec3 integer_in_low_word = Vec3::Zero();

  void archive(Archive& a) { a(per_metre, metres, integer_in_low_word); }
};

/// One instant; kept twice, one read while the other is written.
struct Kinematics {
  AlignedVector<Row> rows;
  AlignedVector<Spin> spins;                 ///< empty where nothing turns
  AlignedVector<CompactRow> compact_rows;    ///< empty in double precision
  AlignedVector<CompactSpin> compact_spins;  ///< empty in double precision or where nothing turns

  void archive(Archive& a) { a(rows, spins, compact_rows, compact_spins); }
};

/// Everything a particle keeps from step to step, by slot. Some slots are empty: those that fill up the last lanes, and
/// the last of all, which stands for no neighbour: nothing touches it, since its position is not a number.
struct Particles {
  static constexpr std::int32_t no_particle = -1;

  Kinematics now, next;
  /// Half a step before `now` [m/s, rad/s]; empty where contacts see these velocities and the rows hold them.
  VectorArray half_velocity, half_angular_velocity;
  VectorArray force;                      ///< [N]; empty where motion follows at once
  AlignedVector<double> mass;             ///< at full size [kg]; 0 in an empty slot
  AlignedVector<double> inverse_inertia;  ///< at full size, of 2/5 m R^2 [1/(kg m2)]; empty where nothing turns
  std::vector<std::int32_t> id;           ///< no_particle in an empty slot
  std::vector<std::int32_t> type;         ///< [[particles]] entry
  std::vector<std::int32_t> material;
  std::size_t count = 0;  ///< particles, not slots
  Places places;          ///< of the compact rows

  AlignedVector<double> spare_numbers;       ///< for reorder
  std::vector<std::int32_t> spare_integers;  ///< for reorder

  std::size_t size() const { return count; }
  std::size_t slots() const { return id.size(); }
  bool turns() const { return !now.spins.empty(); }
  /// Half a step before `now` [m/s].
  Vec3 half_step_velocity(std::size_t slot) const {
    return half_velocity.empty() ? now.rows[slot].velocity : half_velocity.get(slot);
  }
  bool is_particle(std::size_t slot) const { return id[slot] != no_particle; }
  /// The slot that stands for no neighbour.
  std::int32_t nobody() const { return static_cast<std::int32_t>(slots()) - 1; }

  /// Puts into each slot what was in slot `from[slot]`, nothing where that is no_particle. The last must be so.
  void reorder(const std::vector<std::int32_t>& from);
  /// Makes the compact rows from the others. period: of the places, along each axis [m]; middle: of the box [m].
  void make_compact(const Vec3& period, const Vec3& middle);

  void archive(Archive& a) {
    a(now, next, half_velocity, half_angular_velocity, force, mass, inverse_inertia, id, type, material, count, places);
  }
};

/// Radii as a share of full size; 1 and 0 outside a growth filling.
struct Growth {
  double scale = 1;
  double rate = 0;  ///< [1/s]
};

}  // namespace packstone::engine
