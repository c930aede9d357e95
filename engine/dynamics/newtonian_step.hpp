// Newton's equations, Zhong et al., Acta Phys. Sin. 58 (2009), eqs [1], [2], by the leapfrog scheme:
//   v(n+1/2) = v(n-1/2) + dt a(n),   x(n+1) = x(n) + dt v(n+1/2).
// Forces that depend on velocity see v(n) = v(n-1/2) + dt/2 a(n-1), of second order, rather than the lagging half-step
// velocity, which feeds energy into contacts with friction.
//
// Forces and motion are one pass: the state of instant n is read from one buffer and that of n+1 written to the other.
// A group of particles goes through it side by side, one a lane (neighbour_list.hpp).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/contact/pair_table.hpp"
#include "engine/dynamics/contact_history.hpp"
#include "engine/dynamics/lane_sums.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/simd/vector.hpp"
#include "engine/threads.hpp"

namespace packstone::engine {

template <class Lanes, class Normal, class Tangential>
class NewtonianStep final : public Dynamics {
 public:
  NewtonianStep(const Scene& scene, const Domain& domain, const std::vector<Plane>& planes)
      : domain_(domain),
        planes_(planes),
        list_(domain, Lanes::width),
        normal_(scene.materials),
        tangential_(scene.materials) {
    const Vec3 side = domain.size();
    for (int axis = 0; axis < 3; ++axis) inverse_side_[axis] = domain.periodic[axis] ? 1 / side[axis] : 0;
  }

  const NeighbourList& neighbours() const override { return list_; }

  void rebuild(Particles& particles, const Growth& growth, double dt) override {
    if (list_.builds() == 0) alike_ = all_alike(particles);
    if constexpr (Tangential::active) {
      const StoredContacts stored = history_.store(list_, particles, planes_.size());
      list_.build(particles, growth, dt);
      history_.restore(stored, list_, particles, planes_.size());
    } else {
      list_.build(particles, growth, dt);
    }
  }

  StepSums advance(Particles& particles, const StepInput& input, Recorder* recorder) override {
    if (recorder) return advance_all<true, false>(particles, input, recorder);
    return alike_ ? advance_all<false, true>(particles, input, nullptr)
                  : advance_all<false, false>(particles, input, nullptr);
  }

 private:
  /// How far ahead of their use rows are asked for [slots]: neighbours are read about a column of cells ahead.
  static constexpr std::int32_t rows_read_ahead = 1024, rows_written_ahead = 64;

  /// Some particles side by side, as a contact sees them.
  template <class L>
  struct Bodies {
    using Real = typename L::Real;
    simd::Vector<Real> position;  ///< [m]
    Real radius;                  ///< at full size; 0 for a wall [m]
    simd::Vector<Real> velocity;
    Real inverse_mass;  ///< 0 for a wall [1/kg]
    simd::Vector<Real> angular_velocity;
  };

  template <class L>
  struct Loads {
    simd::Vector<typename L::Real> force, torque;
  };

  /// Contacts of each lane with one body.
  template <class L>
  struct Place {
    using Real = typename L::Real;
    typename L::Mask touching;
    simd::Vector<Real> separation;  ///< from the second body to the first
    Real inverse_distance;          ///< 1/|separation|
    Real overlap;
  };

  /// One radius, mass and material: then the loop over neighbours need not look them up.
  static bool all_alike(const Particles& p) {
    const Row& model = p.now.rows.front();
    for (std::size_t s = 0; s < p.slots(); ++s) {
      if (!p.is_particle(s)) continue;
      const Row& row = p.now.rows[s];
      if (row.radius != model.radius || row.inverse_mass != model.inverse_mass) return false;
    }
    return true;
  }

  template <bool record, bool alike>
  StepSums advance_all(Particles& particles, const StepInput& input, Recorder* recorder) {
    const auto blocks = static_cast<std::ptrdiff_t>(list_.blocks().size());
    results_.resize(list_.blocks().size());
#pragma omp parallel for schedule(dynamic) num_threads(useful_threads(particles.size()))
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      results_[b] = {};
      advance_block<record, alike>(particles, b, input, recorder);
    }
    // Blocks are added in order, so that the sums have the same bits for any number of threads.
    StepSums sums;
    Vec3 displacement = Vec3::Zero();
    for (const BlockResult& block : results_) {
      sums.add(block.sums);
      displacement += block.displacement;
      if (recorder && recorder->want_contacts) append(recorder->contacts, block.contacts);
    }
    list_.moved(sums.largest_share_squared, displacement, input.dt);
    return sums;
  }

  template <bool record, bool alike>
  void advance_block(Particles& p, std::ptrdiff_t block, const StepInput& in, Recorder* recorder) {
    BlockResult& result = results_[block];
    LaneSums<Lanes> sums;
    LaneSums<simd::Scalar> alone_sums;
    const GroupBlock& groups = list_.blocks()[block];
    for (std::int32_t g = groups.first; g < groups.last; ++g) {
      const NeighbourGroup& group = list_.groups()[g];
      prefetch_for_next(p, g);
      if (group.shared) {
        const auto self = bodies_alone<Lanes>(p, group.slot);
        const Loads<Lanes> loads = pair_loads<record, alike>(p, group, self, in, recorder, sums, result);
        const Loads<simd::Scalar> total{total_of(loads.force), total_of(loads.torque)};
        finish<record, simd::Scalar>(p, g, bodies_alone<simd::Scalar>(p, group.slot), total, in, recorder, alone_sums,
                                     result);
      } else {
        const auto self = bodies_in_line(p, group.slot);
        const Loads<Lanes> loads = pair_loads<record, alike>(p, group, self, in, recorder, sums, result);
        finish<record, Lanes>(p, g, self, loads, in, recorder, sums, result);
      }
    }
    sums.add_to(result, in);
    alone_sums.add_to(result, in);
    if (sums.beyond_limit() || alone_sums.beyond_limit()) result.sums.offence = offence_in(p, groups, in);
  }

  /// Asks for what the next group will read, and for what comes soon after: the rows of neighbours lie scattered, and a
  /// step waits for memory more than it computes (docs/performance.md).
  [[gnu::always_inline]] void prefetch_for_next(Particles& p, std::int32_t g) const {
    const std::size_t last = list_.groups().size() - 1;
    const NeighbourGroup& next = list_.groups()[std::min<std::size_t>(g + 1, last)];
    const double* rows = numbers(p.now.rows.data());
    const std::uint32_t* entry = list_.row(next.first_row);
    const std::uint32_t* const end = entry + static_cast<std::size_t>(next.rows) * Lanes::width;
    for (; entry < end; ++entry) {
      __builtin_prefetch(rows + *entry);
      if constexpr (Tangential::active) __builtin_prefetch(numbers(p.now.spins.data()) + *entry / 2);
    }
    const auto slots = static_cast<std::int32_t>(p.slots());
    const std::int32_t read = std::min(next.slot + rows_read_ahead, slots - Lanes::width);
    const std::int32_t write = std::min(next.slot + rows_written_ahead, slots - Lanes::width);
    constexpr int for_writing = 1, into_second_level = 2;
    for (int k = 0; k < Lanes::width; ++k) {
      __builtin_prefetch(&p.now.rows[std::max(read, 0) + k], 0, into_second_level);
      __builtin_prefetch(&p.next.rows[std::max(write, 0) + k], for_writing, into_second_level);
    }
  }

  /// The first contact of these groups whose overlap is beyond the limit.
  [[gnu::noinline]] std::optional<Offence> offence_in(const Particles& p, const GroupBlock& groups,
                                                      const StepInput& in) const {
    const auto beyond = [&](double overlap, std::size_t slot) {
      return overlap > in.overlap_limit * p.now.rows[slot].radius;
    };
    for (std::int32_t g = groups.first; g < groups.last; ++g) {
      const NeighbourGroup& group = list_.groups()[g];
      for (int lane = 0; lane < Lanes::width; ++lane) {
        const auto i = static_cast<std::size_t>(group.shared ? group.slot : group.slot + lane);
        if (!group.shared && (group.lanes >> lane & 1u) == 0) continue;
        const Row& first = p.now.rows[i];
        for (std::int64_t row = group.first_row; row < group.first_row + group.rows; ++row) {
          const std::int32_t j = NeighbourList::slot(list_.row(row)[lane]);
          const Row& second = p.now.rows[j];
          const double distance = domain_.separation(first.position, second.position).norm();
          const double overlap = in.growth.scale * (first.radius + second.radius) - distance;
          if (beyond(overlap, i)) return Offence{p.id[i], p.id[j], overlap};
        }
        for (std::size_t w = 0; w < planes_.size(); ++w) {
          const double overlap = in.growth.scale * first.radius - planes_[w].distance(first.position);
          if (beyond(overlap, i)) return Offence{p.id[i], -1 - static_cast<std::int64_t>(w), overlap};
        }
      }
    }
    return std::nullopt;
  }

  static simd::Vector<double> total_of(const simd::Vector<typename Lanes::Real>& v) {
    using simd::sum;
    return {sum(v.x), sum(v.y), sum(v.z)};
  }

  static constexpr std::size_t row_stride = sizeof(Row) / sizeof(double);
  static constexpr std::size_t spin_stride = sizeof(Spin) / sizeof(double);
  static constexpr std::size_t velocity_offset = offsetof(Row, velocity) / sizeof(double);
  static const double* numbers(const Row* rows) { return reinterpret_cast<const double*>(rows); }
  static const double* numbers(const Spin* spins) { return reinterpret_cast<const double*>(spins); }

  [[gnu::always_inline]] Bodies<Lanes> bodies_in_line(const Particles& p, std::int32_t slot) const {
    typename Lanes::Real c[8];
    Lanes::template read_columns<8, row_stride>(numbers(&p.now.rows[slot]), c);
    Bodies<Lanes> b{{c[0], c[1], c[2]}, c[3], {c[4], c[5], c[6]}, c[7], {}};
    if constexpr (Tangential::active) {
      Lanes::template read_columns<3, spin_stride>(numbers(&p.now.spins[slot]), c);
      b.angular_velocity = {c[0], c[1], c[2]};
    }
    return b;
  }

  static simd::Vector<typename Lanes::Real> spins_of(const Particles& p, const std::uint32_t* neighbour) {
    static_assert(row_stride == 2 * spin_stride);
    std::uint32_t offset[Lanes::width];
    for (int lane = 0; lane < Lanes::width; ++lane) offset[lane] = neighbour[lane] / 2;
    typename Lanes::Real c[3];
    Lanes::template read_columns<3>(numbers(p.now.spins.data()), offset, c);
    return {c[0], c[1], c[2]};
  }

  template <class L>
  Bodies<L> bodies_alone(const Particles& p, std::int32_t slot) const {
    using Real = typename L::Real;
    const auto vector = [](const Vec3& v) { return simd::Vector<Real>{Real(v[0]), Real(v[1]), Real(v[2])}; };
    const Row& row = p.now.rows[slot];
    Bodies<L> b{vector(row.position), Real(row.radius), vector(row.velocity), Real(row.inverse_mass), {}};
    if constexpr (Tangential::active) b.angular_velocity = vector(p.now.spins[slot].angular_velocity);
    return b;
  }

  /// Forces from the particles in the group's rows.
  template <bool record, bool alike>
  [[gnu::always_inline]] Loads<Lanes> pair_loads(const Particles& p, const NeighbourGroup& group,
                                                 const Bodies<Lanes>& self, const StepInput& in, Recorder* recorder,
                                                 LaneSums<Lanes>& sums, BlockResult& result) {
    using simd::any, simd::inverse_sqrt;
    using Real = typename Lanes::Real;
    Loads<Lanes> loads{simd::Vector<Real>::zero(), simd::Vector<Real>::zero()};
    const double* rows = numbers(p.now.rows.data());
    for (std::int64_t row = group.first_row; row < group.first_row + group.rows; ++row) {
      const std::uint32_t* neighbour = list_.row(row);
      Bodies<Lanes> other;
      Real c[4];
      Lanes::template read_columns<alike ? 3 : 4>(rows, neighbour, c);
      simd::Vector<Real> d = self.position - simd::Vector<Real>{c[0], c[1], c[2]};
      if (group.images) d = nearest_image(d);
      other.radius = alike ? self.radius : c[3];
      const Real reach = Real(in.growth.scale) * (self.radius + other.radius);
      const Real squared = squared_length(d);
      const auto touching = squared < reach * reach;
      if (!any(touching)) {
        if constexpr (Tangential::active) history_.pairs.none(row);
        continue;
      }
      Lanes::template read_columns<alike ? 3 : 4>(rows + velocity_offset, neighbour, c);
      other.velocity = {c[0], c[1], c[2]};
      other.inverse_mass = alike ? self.inverse_mass : c[3];
      if constexpr (Tangential::active) {
        other.angular_velocity = spins_of(p, neighbour);
      }
      const Real inverse_distance = inverse_sqrt(squared);
      const Place<Lanes> at{touching, d, inverse_distance, reach - squared * inverse_distance};
      const auto slots = [&](int lane) {
        return std::pair{group.shared ? group.slot : group.slot + lane, NeighbourList::slot(neighbour[lane])};
      };
      const auto who = [&](int lane) {
        const auto [first, second] = slots(lane);
        return std::pair<std::int64_t, std::int64_t>{p.id[first], p.id[second]};
      };
      const auto materials = [&](int lane) {
        const auto [first, second] = slots(lane);
        return std::pair{p.material[first], p.material[second]};
      };
      touch<record, alike, Lanes>(self, other, at, history_.pairs, row, materials, who, in, recorder, loads, sums.pairs,
                                  result);
    }
    return loads;
  }

  /// Forces from walls, then the motion.
  template <bool record, class L>
  [[gnu::always_inline]] void finish(Particles& p, std::int32_t g, const Bodies<L>& self, Loads<L> loads,
                                     const StepInput& in, Recorder* recorder, LaneSums<L>& sums, BlockResult& result) {
    using simd::any;
    using Real = typename L::Real;
    const NeighbourGroup& group = list_.groups()[g];
    const auto occupied = L::mask(group.lanes);
    const auto groups = static_cast<std::int64_t>(list_.groups().size());
    for (std::size_t w = 0; w < planes_.size(); ++w) {
      const Plane& plane = planes_[w];
      const simd::Vector<Real> normal{Real(plane.normal[0]), Real(plane.normal[1]), Real(plane.normal[2])};
      const simd::Vector<Real> point{Real(plane.point[0]), Real(plane.point[1]), Real(plane.point[2])};
      const Real overlap = Real(in.growth.scale) * self.radius - dot(self.position - point, normal);
      const typename L::Mask touching = (Real(0.0) < overlap) & occupied;
      const std::int64_t row = static_cast<std::int64_t>(w) * groups + g;
      if (!any(touching)) {
        if constexpr (Tangential::active) history_.walls.none(row);
        continue;
      }
      Bodies<L> wall{self.position, Real(0.0), simd::Vector<Real>::zero(), Real(0.0), simd::Vector<Real>::zero()};
      const Place<L> at{touching, normal, Real(1.0), overlap};
      const auto who = [&](int lane) {
        return std::pair<std::int64_t, std::int64_t>{p.id[group.slot + lane], -1 - static_cast<std::int64_t>(w)};
      };
      const auto materials = [&](int lane) {
        return std::pair{p.material[group.slot + lane], static_cast<std::int32_t>(plane.material)};
      };
      touch<record, false, L>(self, wall, at, history_.walls, row, materials, who, in, recorder, loads, sums.walls,
                              result);
    }
    move<record, L>(p, group, self, loads, occupied, in, recorder, sums);
  }

  /// d less the box's sides that it is nearest to; unchanged along axes that are not periodic.
  simd::Vector<typename Lanes::Real> nearest_image(const simd::Vector<typename Lanes::Real>& d) const {
    using simd::fused, simd::nearest_integer;
    using Real = typename Lanes::Real;
    const Vec3 side = domain_.size();
    const auto along = [&](const Real& x, int axis) {
      return fused(-nearest_integer(x * Real(inverse_side_[axis])), Real(side[axis]), x);
    };
    return {along(d.x, 0), along(d.y, 1), along(d.z, 2)};
  }

  /// A law's parameters for each lane's pair of materials.
  template <bool alike, class L, class Law, class Materials>
  [[gnu::always_inline]] static auto parameters(const PairTable<Law>& table, const Materials& materials) {
    using Real = typename L::Real;
    using Parameters = typename Law::template Parameters<Real>;
    if (alike || table.materials() == 1) return Parameters::from([&](int k) { return Real(*table.table(k)); });
    return looked_up<L>(table, materials);
  }

  /// Kept out of the loop, whose registers it would take.
  template <class L, class Law, class Materials>
  [[gnu::noinline]] static auto looked_up(const PairTable<Law>& table, const Materials& materials) {
    using Parameters = typename Law::template Parameters<typename L::Real>;
    std::int32_t pair[L::width];
    for (int lane = 0; lane < L::width; ++lane) {
      const auto [a, b] = materials(lane);
      pair[lane] = a * static_cast<std::int32_t>(table.materials()) + b;
    }
    return Parameters::from([&](int k) { return L::gather(table.table(k), pair); });
  }

  /// Adds the forces and torques of some contacts on the first bodies.
  template <bool record, bool alike, class L, class Materials, class Who>
  [[gnu::always_inline]] void touch(const Bodies<L>& first, const Bodies<L>& second, const Place<L>& at,
                                    Springs& springs, std::int64_t row, const Materials& materials, const Who& who,
                                    const StepInput& in, Recorder* recorder, Loads<L>& loads,
                                    ContactSums<typename L::Real>& sums, BlockResult& result) const {
    using simd::bits, simd::fused, simd::fused_where, simd::larger, simd::only;
    using Real = typename L::Real;
    const simd::Vector<Real> relative = first.velocity - second.velocity;
    const Real growth_rate = Real(in.growth.rate) * (first.radius + second.radius);
    const Real rate = fused(-at.inverse_distance, dot(relative, at.separation), growth_rate);
    const auto law = parameters<alike, L>(normal_, materials);
    const NormalForce<Real> normal = Normal::force(law, at.overlap, rate, first.inverse_mass + second.inverse_mass);
    const Real total = normal.total();
    loads.force = fused_where(at.touching, total * at.inverse_distance, at.separation, loads.force);
    sums.damping_power = fused_where(at.touching, normal.damping, rate, sums.damping_power);
    if (in.growth.rate != 0) sums.growth_power = fused_where(at.touching, total, growth_rate, sums.growth_power);
    sums.deepest = larger(fused(Real(-in.overlap_limit), first.radius, at.overlap), sums.deepest);
    [[maybe_unused]] const simd::Vector<Real> n = at.inverse_distance * at.separation;
    [[maybe_unused]] simd::Vector<Real> tangential_force = simd::Vector<Real>::zero();
    [[maybe_unused]] std::uint32_t sliding = 0;
    [[maybe_unused]] Real elastic = Normal::energy(law, at.overlap);
    if constexpr (Tangential::active) {
      // Lever arms at the instant's radii; the sum has the same bits seen from either body.
      const simd::Vector<Real> spin =
          Real(in.growth.scale) * (first.radius * first.angular_velocity + second.radius * second.angular_velocity);
      const simd::Vector<Real> contact_velocity = relative - cross(spin, n);
      const simd::Vector<Real> sliding_velocity = fused(-dot(contact_velocity, n), n, contact_velocity);
      simd::Vector<Real> spring = springs.load<L>(row);
      const auto friction =
          Tangential::advance(parameters<alike, L>(tangential_, materials), spring, n, sliding_velocity, total, in.dt);
      springs.store<L>(row, at.touching, spring);
      tangential_force = only(at.touching, friction.force);
      loads.force += tangential_force;
      loads.torque -= Real(in.growth.scale) * first.radius * only(at.touching, cross(n, tangential_force));
      sums.sliding_loss += only(at.touching, friction.dissipated);
      elastic += friction.elastic;
      sliding = bits(friction.sliding);
    }
    if constexpr (record) {
      sums.elastic += only(at.touching, elastic);
      for (std::uint32_t lanes = bits(at.touching); lanes != 0; lanes &= lanes - 1) {
        const int k = std::countr_zero(lanes);
        const auto lane = [&](const simd::Vector<Real>& v) {
          return Vec3(L::lane(v.x, k), L::lane(v.y, k), L::lane(v.z, k));
        };
        const auto [a, b] = who(k);
        const double overlap = L::lane(at.overlap, k), radius = L::lane(first.radius, k);
        result.sums.largest_overlap_share = std::max(result.sums.largest_overlap_share, overlap / radius);
        if (b >= 0 && b < a) continue;
        ++(b < 0 ? result.sums.wall_contacts : result.sums.particle_contacts);
        if (!recorder->want_contacts) continue;
        const Vec3 normal_k = lane(n);
        Contacts& c = result.contacts;
        c.first.push_back(a);
        c.second.push_back(b);
        c.force.push_back(L::lane(total, k) * normal_k + lane(tangential_force));
        c.normal.push_back(normal_k);
        c.overlap.push_back(overlap);
        c.point.push_back(lane(first.position) - (in.growth.scale * radius - 0.5 * overlap) * normal_k);
        c.sliding.push_back((sliding >> k & 1u) != 0);
      }
    }
  }

  template <bool record, class L>
  [[gnu::always_inline]] void move(Particles& p, const NeighbourGroup& group, const Bodies<L>& self,
                                   const Loads<L>& loads, typename L::Mask occupied, const StepInput& in,
                                   Recorder* recorder, LaneSums<L>& sums) const {
    using simd::larger;
    using Real = typename L::Real;
    using Vector = simd::Vector<Real>;
    const auto load = [&](const VectorArray& v) {
      return Vector{L::load(&v.x[group.slot]), L::load(&v.y[group.slot]), L::load(&v.z[group.slot])};
    };
    const auto store = [&](VectorArray& to, const Vector& v) {
      L::store(&to.x[group.slot], v.x);
      L::store(&to.y[group.slot], v.y);
      L::store(&to.z[group.slot], v.z);
    };
    const Real dt(in.dt);
    const Vector gravity{Real(in.gravity[0]), Real(in.gravity[1]), Real(in.gravity[2])};
    const Vector before = load(p.half_velocity);
    const Vector acceleration = fused(self.inverse_mass, loads.force, gravity);
    const Vector half = fused(dt, acceleration, before);
    const Vector position = fused(dt, half, self.position);
    const Vector velocity = fused(Real(in.velocity_lead), acceleration, half);
    store(p.half_velocity, half);
    double* row = reinterpret_cast<double*>(&p.next.rows[group.slot]);
    const Real low[4] = {position.x, position.y, position.z, self.radius};
    const Real high[4] = {velocity.x, velocity.y, velocity.z, self.inverse_mass};
    L::template write_columns<row_stride>(row, low);
    L::template write_columns<row_stride>(row + 4, high);

    const Real mass = L::load(&p.mass[group.slot]);
    sums.momentum = fused(mass, half, sums.momentum);
    const Vector moved = position - load(list_.reference());
    sums.displacement += only(occupied, moved);
    const Vec3 common = list_.expected_displacement();
    const Vector deviation = moved - Vector{Real(common[0]), Real(common[1]), Real(common[2])};
    const Real share = squared_length(deviation) * L::load(&list_.inverse_margin_squared()[group.slot]);
    sums.largest_share_squared = larger(sums.largest_share_squared, share);
    sums.within_margins = sums.within_margins & (share < Real(1.0));

    [[maybe_unused]] Vector half_turn_before = Vector::zero(), angular_acceleration = Vector::zero();
    if constexpr (Tangential::active) {
      half_turn_before = load(p.half_angular_velocity);
      angular_acceleration = L::load(&p.inverse_inertia[group.slot]) * loads.torque;
      const Vector half_turn = fused(dt, angular_acceleration, half_turn_before);
      store(p.half_angular_velocity, half_turn);
      const Vector turn = fused(Real(in.velocity_lead), angular_acceleration, half_turn);
      const Real spin[4] = {turn.x, turn.y, turn.z, Real(0.0)};
      L::template write_columns<spin_stride>(reinterpret_cast<double*>(&p.next.spins[group.slot]), spin);
    }
    if constexpr (record) {
      for (int k = 0; k < L::width; ++k) {
        const std::size_t slot = static_cast<std::size_t>(group.slot) + k;
        if ((group.lanes >> k & 1u) == 0) continue;
        const auto lane = [&](const Vector& v) { return Vec3(L::lane(v.x, k), L::lane(v.y, k), L::lane(v.z, k)); };
        const Vec3 a = lane(acceleration), v = lane(before) + 0.5 * in.dt * a;
        sums.recorded.kinetic_translational += 0.5 * p.mass[slot] * v.squaredNorm();
        sums.recorded.largest_speed_squared = std::max(sums.recorded.largest_speed_squared, v.squaredNorm());
        recorder->velocity[p.id[slot]] = v;
        recorder->force[p.id[slot]] = p.mass[slot] * a;
        if constexpr (Tangential::active) {
          const Vec3 turn = lane(half_turn_before) + 0.5 * in.dt * lane(angular_acceleration);
          sums.recorded.kinetic_rotational += 0.5 / p.inverse_inertia[slot] * turn.squaredNorm();
          recorder->angular_velocity[p.id[slot]] = turn;
        }
      }
    }
  }

  static void append(Contacts& to, const Contacts& from) {
    const auto extend = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
    extend(to.first, from.first);
    extend(to.second, from.second);
    extend(to.force, from.force);
    extend(to.normal, from.normal);
    extend(to.overlap, from.overlap);
    extend(to.point, from.point);
    extend(to.sliding, from.sliding);
  }

  Domain domain_;
  Vec3 inverse_side_;  ///< 0 along axes that are not periodic [1/m]
  std::vector<Plane> planes_;
  NeighbourList list_;
  bool alike_ = false;
  PairTable<Normal> normal_;
  PairTable<Tangential> tangential_;
  ContactHistory history_;
  std::vector<BlockResult> results_;
};

}  // namespace packstone::engine
