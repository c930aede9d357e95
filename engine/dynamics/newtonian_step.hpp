// One step: forces and motion in one pass. The state of instant n is read from one buffer and that of n+1 written to
// the other. A group of particles goes through it side by side, one a lane (neighbour_list.hpp).
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/dynamics/contact_forces.hpp"
#include "engine/dynamics/contact_history.hpp"
#include "engine/dynamics/lane_sums.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/simd/vector.hpp"
#include "engine/threads.hpp"

namespace packstone::engine {

template <class Lanes, class Normal, class Tangential>
class NewtonianStep final : public Dynamics {
 public:
  NewtonianStep(const Scene& scene, const Domain& domain, const std::vector<Plane>& planes)
      : domain_(domain), planes_(planes), list_(domain, Lanes::width), forces_(scene.materials) {
    const Vec3 side = domain.size();
    for (int axis = 0; axis < 3; ++axis) inverse_side_[axis] = domain.periodic[axis] ? 1 / side[axis] : 0;
  }

  const NeighbourList& neighbours() const override { return list_; }

  void rebuild(Particles& particles, const Growth& growth, double dt) override {
    if (list_.builds() == 0) look_whether_alike(particles);
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
    const bool alike = alike_ && input.growth.rate == 0;
    return alike ? advance_all<false, true>(particles, input, nullptr)
                 : advance_all<false, false>(particles, input, nullptr);
  }

 private:
  /// How far ahead of their use rows are asked for [slots]: neighbours are read about a column of cells ahead.
  static constexpr std::int32_t rows_read_ahead = 1024, rows_written_ahead = 64;

  /// Fewer are in the second-level cache anyhow, and asking costs a sixth of the step.
  static constexpr std::size_t slots_in_cache = 2000;

  /// One radius, mass and material: then the loop over neighbours need not look them up.
  void look_whether_alike(const Particles& p) {
    const Row& model = p.now.rows.front();
    alike_ = true;
    for (std::size_t s = 0; s < p.slots(); ++s) {
      if (!p.is_particle(s)) continue;
      const Row& row = p.now.rows[s];
      alike_ = alike_ && row.radius == model.radius && row.inverse_mass == model.inverse_mass &&
               p.material[s] == p.material.front();
    }
    if (alike_) forces_.set_material_of_alike(p.material.front());
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
      if (recorder && recorder->want_contacts) recorder->contacts.append(block.contacts);
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
    const bool beyond_cache = p.slots() > slots_in_cache;
    for (std::int32_t g = groups.first; g < groups.last; ++g) {
      const NeighbourGroup& group = list_.groups()[g];
      if (beyond_cache) prefetch_for_next(p, g);
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
    for (; entry < end; entry += Lanes::width) {
      for (int k = 0; k < Lanes::width; ++k) {
        __builtin_prefetch(rows + entry[k]);
        if constexpr (Tangential::active) __builtin_prefetch(numbers(p.now.spins.data()) + entry[k] / 2);
      }
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

  static const double* numbers(const Row* rows) { return reinterpret_cast<const double*>(rows); }
  static const double* numbers(const Spin* spins) { return reinterpret_cast<const double*>(spins); }

  [[gnu::always_inline]] Bodies<Lanes> bodies_in_line(const Particles& p, std::int32_t slot) const {
    typename Lanes::Real c[8];
    Lanes::template read_columns<8, Row::doubles>(numbers(&p.now.rows[slot]), c);
    Bodies<Lanes> b{{c[0], c[1], c[2]}, c[3], {c[4], c[5], c[6]}, c[7], {}};
    if constexpr (Tangential::active) {
      Lanes::template read_columns<3, Spin::doubles>(numbers(&p.now.spins[slot]), c);
      b.angular_velocity = {c[0], c[1], c[2]};
    }
    return b;
  }

  [[gnu::always_inline]] static simd::Vector<typename Lanes::Real> spins_of(const Particles& p,
                                                                            const std::uint32_t* neighbour) {
    static_assert(Row::doubles == 2 * Spin::doubles);
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
    using simd::any, simd::fused, simd::inverse_sqrt;
    using Real = typename Lanes::Real;
    Loads<Lanes> loads{simd::Vector<Real>::zero(), simd::Vector<Real>::zero()};
    ContactSums<Real> pairs;  // of this group, in registers
    const double* rows = numbers(p.now.rows.data());
    const Real scale(in.growth.scale);
    const Real reach_of_alike = scale * (self.radius + self.radius);
    const auto laws_of_alike = forces_.template laws_of_alike<Lanes>(self.inverse_mass);
    for (std::int64_t row = group.first_row; row < group.first_row + group.rows; ++row) {
      const std::uint32_t* neighbour = list_.row(row);
      Bodies<Lanes> other;
      Real c[4];
      Lanes::template read_columns<alike ? 3 : 4>(rows, neighbour, c);
      simd::Vector<Real> d = self.position - simd::Vector<Real>{c[0], c[1], c[2]};
      if (group.images) d = nearest_image(d);
      other.radius = alike ? self.radius : c[3];
      const Real reach = alike ? reach_of_alike : scale * (self.radius + other.radius);
      const Real squared = squared_length(d);
      const auto touching = squared < reach * reach;
      if (!any(touching)) {
        if constexpr (Tangential::active) history_.pairs.none(row);
        continue;
      }
      Lanes::template read_columns<alike ? 3 : 4>(rows + Row::velocity_at, neighbour, c);
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
      const auto add = [&](const auto& laws) __attribute__((always_inline)) {
        forces_.template add<record, alike, Lanes>(self, other, at, laws, history_.pairs, row, who, in, recorder, loads,
                                                   pairs, result);
      };
      if constexpr (alike) {
        add(laws_of_alike);
      } else {
        const auto materials = [&](int lane) {
          const auto [first, second] = slots(lane);
          return std::pair{p.material[first], p.material[second]};
        };
        add(forces_.template laws<Lanes>(materials, self.inverse_mass + other.inverse_mass));
      }
    }
    if constexpr (alike) pairs.deepest = fused(Real(-in.overlap_limit), self.radius, pairs.deepest);
    sums.pairs.add(pairs);
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
      const auto laws = forces_.template laws<L>(materials, self.inverse_mass);
      forces_.template add<record, false, L>(self, wall, at, laws, history_.walls, row, who, in, recorder, loads,
                                             sums.walls, result);
    }
    move<record, Tangential::active, L>(p, list_, group, self, loads, occupied, in, recorder, sums);
  }

  /// d less the box's sides that it is nearest to; unchanged along axes that are not periodic.
  [[gnu::always_inline]] simd::Vector<typename Lanes::Real> nearest_image(
      const simd::Vector<typename Lanes::Real>& d) const {
    using simd::fused, simd::nearest_integer;
    using Real = typename Lanes::Real;
    const Vec3 side = domain_.size();
    const auto along = [&](const Real& x, int axis) {
      return fused(-nearest_integer(x * Real(inverse_side_[axis])), Real(side[axis]), x);
    };
    return {along(d.x, 0), along(d.y, 1), along(d.z, 2)};
  }

  Domain domain_;
  Vec3 inverse_side_;  ///< 0 along axes that are not periodic [1/m]
  std::vector<Plane> planes_;
  NeighbourList list_;
  bool alike_ = false;
  ContactForces<Normal, Tangential> forces_;
  ContactHistory history_;
  std::vector<BlockResult> results_;
};

}  // namespace packstone::engine
