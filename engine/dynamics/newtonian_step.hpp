// One step: forces and motion in one pass. The state of instant n is read from one buffer and that of n+1 written to
// the other. A group of particles goes through it side by side, one a lane (neighbour_list.hpp). Or forces alone, for
// motion that is made elsewhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "engine/dynamics/contact_forces.hpp"
#include "engine/dynamics/contact_history.hpp"
#include "engine/dynamics/lane_sums.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/precision.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/dynamics/wall_forces.hpp"
#include "engine/simd/vector.hpp"
#include "engine/threads.hpp"

namespace packstone::engine {

/// moves: false leaves the particles where they are and their forces, of contacts, in Particles::force.
template <class Precision, class Normal, class Tangential, bool moves = true>
class NewtonianStep final : public Dynamics {
  using Lanes = typename Precision::Lanes;
  using PairLanes = typename Precision::PairLanes;

 public:
  NewtonianStep(const Scene& scene, const Domain& domain, const Boundaries& boundaries)
      : domain_(domain),
        boundaries_(boundaries),
        forces_(scene.contact, scene.materials),
        list_(domain, PairLanes::width, forces_.range(), scene.dynamics.list_margin),
        walls_(boundaries, Lanes::width),
        from_walls_(domain, boundaries, forces_, list_, walls_, history_.walls),
        wall_loads_(boundaries.size()) {
    history_.numbers = forces_.kept();
  }

  const NeighbourList& neighbours() const override { return list_; }
  const std::vector<WallLoad>& wall_loads() const override { return wall_loads_; }

  NeighbourList& list() { return list_; }
  WallList& walls() { return walls_; }
  const ContactForces<Normal, Tangential>& forces() const { return forces_; }

  bool outdated(const Growth& growth) const override { return list_.outdated(growth) || walls_.outdated(list_); }

  std::optional<StepSums> go_on(Particles& particles, const StepInput& /*input*/, double /*time*/) override {
    std::swap(particles.now, particles.next);
    return StepSums{};
  }

  void archive(Archive& a, Particles& particles) override {
    a(list_, walls_, history_.pairs, history_.walls);
    if (!a.reads() || list_.builds() == 0) return;
    look_whether_alike(particles);
    from_walls_.make_room();
  }

  void rebuild(Particles& particles, const Growth& growth, double dt) override { rebuild(particles, growth, dt, 0); }
  /// least_share: as in NeighbourList::build.
  void rebuild(Particles& particles, const Growth& growth, double dt, double least_share) {
    if (seen_ != particles.size()) look_whether_alike(particles);
    if (remembers()) {
      const StoredContacts stored = history_.store(list_, walls_, particles);
      list_.build(particles, growth, dt, least_share);
      walls_.build(list_, particles, dt);
      history_.restore(stored, list_, walls_, particles);
    } else {
      list_.build(particles, growth, dt, least_share);
      walls_.build(list_, particles, dt);
    }
    from_walls_.make_room();
    if constexpr (!moves) particles.force.resize(particles.slots());
    if constexpr (Precision::compact) particles.make_compact(period_of_places(), 0.5 * (domain_.min + domain_.max));
  }

  StepSums advance(Particles& particles, const StepInput& input, Recorder* recorder) override {
    if (recorder) return advance_all<true, false>(particles, input, recorder);
    const bool alike = alike_ && input.growth.rate == 0;
    return alike ? advance_all<false, true>(particles, input, nullptr)
                 : advance_all<false, false>(particles, input, nullptr);
  }

 private:
  using InDouble = DoublePrecision<Lanes>;
  using Forces = ContactForces<Normal, Tangential>;

  /// How far ahead of their use rows are asked for [slots]: neighbours are read about a column of cells ahead.
  static constexpr std::int32_t rows_read_ahead = 1024, rows_written_ahead = 64;

  /// Fewer are in the second-level cache anyhow, and asking costs a sixth of the step.
  static constexpr std::size_t slots_in_cache = 2000;

  /// Whether contacts keep anything from step to step; where laws are compiled in, a constant.
  [[gnu::always_inline]] bool remembers() const { return Forces::may_remember && forces_.kept() > 0; }

  /// One radius, mass and material: then the loop over neighbours need not look them up.
  void look_whether_alike(const Particles& p) {
    seen_ = p.size();
    const auto first = static_cast<std::size_t>(
        std::find_if(p.id.begin(), p.id.end(), [](std::int32_t id) { return id != Particles::no_particle; }) -
        p.id.begin());
    const Row& model = p.now.rows[first];
    alike_ = true;
    for (std::size_t s = first; s < p.slots(); ++s) {
      if (!p.is_particle(s)) continue;
      const Row& row = p.now.rows[s];
      alike_ = alike_ && row.radius == model.radius && row.inverse_mass == model.inverse_mass &&
               p.material[s] == p.material[first];
    }
    if (alike_) forces_.set_material_of_alike(p.material[first]);
  }

  template <bool record, bool alike>
  StepSums advance_all(Particles& particles, const StepInput& input, Recorder* recorder) {
    const auto blocks = static_cast<std::ptrdiff_t>(list_.blocks().size());
    results_.resize(list_.blocks().size());
    from_walls_.start();
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
    from_walls_.sum_up(wall_loads_);
    for (const WallLoad& load : wall_loads_) sums.wall_work += input.dt * load.power;
    if constexpr (moves) list_.moved(sums.largest_share_squared, displacement, input.dt);
    return sums;
  }

  template <bool record, bool alike>
  void advance_block(Particles& p, std::ptrdiff_t block, const StepInput& in, Recorder* recorder) {
    BlockResult& result = results_[block];
    LaneSums<Lanes> sums;
    LaneSums<simd::Scalar> alone_sums;
    const GroupBlock& groups = list_.blocks()[block];
    const bool beyond_cache = p.slots() > slots_in_cache;
    const Precision seen(p, domain_);
    const InDouble rows(p, domain_);
    const DoublePrecision<simd::Scalar> single_rows(p, domain_);
    constexpr bool turning = Tangential::active;
    const bool beyond_at_walls =
        boundaries_.size() > 0 && from_walls_.template find<record>(p, block, in, recorder, result);
    const WallLoads<Lanes>* from_walls = from_walls_.found();  // of the next seat that has any
    for (std::int32_t g = groups.first; g < groups.last; ++g) {
      const NeighbourGroup& group = list_.groups()[g];
      if (beyond_cache) prefetch_for_next(p, seen, g);
      if (group.shared) {
        const auto self = seen.template body_in_all_lanes<turning>(group.slot);
        const auto loads = pair_loads<record, alike>(p, seen, group, self, in, recorder, sums, result);
        const Loads<simd::Scalar> total{total_of(loads.force), total_of(loads.torque)};
        finish<record>(p, Seats{group.slot, 1}, walls_.seat(g, 0), from_walls,
                       single_rows.template bodies_in_line<turning>(group.slot), total, in, recorder, alone_sums);
      } else if constexpr (Precision::compact) {
        const auto self = seen.template bodies_in_line<turning>(group.slot);
        const auto loads = pair_loads<record, alike>(p, seen, group, self, in, recorder, sums, result);
        for (int part = 0; part < Precision::parts; ++part) {
          const Seats seats = seats_of<Lanes>(group, part);
          const Loads<Lanes> widened{widened_part(loads.force, part), widened_part(loads.torque, part)};
          finish<record>(p, seats, walls_.seat(g, part), from_walls, rows.template bodies_in_line<turning>(seats.slot),
                         widened, in, recorder, sums);
        }
      } else {
        const auto self = rows.template bodies_in_line<turning>(group.slot);
        const auto loads = pair_loads<record, alike>(p, seen, group, self, in, recorder, sums, result);
        finish<record>(p, seats_of<Lanes>(group, 0), walls_.seat(g, 0), from_walls, self, loads, in, recorder, sums);
      }
    }
    sums.add_to(result, in);
    alone_sums.add_to(result, in);
    if (beyond_at_walls || sums.beyond_limit() || alone_sums.beyond_limit()) {
      result.sums.offence = offence_in(p, groups, in);
    }
  }

  /// Asks for what the next group will read, and for what comes soon after: the rows of neighbours lie scattered, and a
  /// step waits for memory more than it computes (docs/performance.md).
  [[gnu::always_inline]] void prefetch_for_next(Particles& p, const Precision& seen, std::int32_t g) const {
    const std::size_t last = list_.groups().size() - 1;
    const NeighbourGroup& next = list_.groups()[std::min<std::size_t>(g + 1, last)];
    const std::uint32_t* entry = list_.row(next.first_row);
    const std::uint32_t* const end = entry + static_cast<std::size_t>(next.rows) * PairLanes::width;
    for (; entry < end; ++entry) seen.prefetch(*entry, Tangential::active);
    if (remembers()) {
      const NeighbourGroup& later = list_.groups()[std::min<std::size_t>(g + 2, last)];
      history_.pairs.prefetch(later.first_row, later.rows, forces_.kept());
    }
    const auto slots = static_cast<std::int32_t>(p.slots());
    const std::int32_t read = std::min(next.slot + rows_read_ahead, slots - PairLanes::width);
    const std::int32_t write = std::min(next.slot + rows_written_ahead, slots - PairLanes::width);
    constexpr int for_writing = 1, into_second_level = 2;
    for (int k = 0; k < PairLanes::width; ++k) {
      __builtin_prefetch(&p.now.rows[std::max(read, 0) + k], 0, into_second_level);
      __builtin_prefetch(&p.next.rows[std::max(write, 0) + k], for_writing, into_second_level);
    }
    if constexpr (Precision::compact) {
      for (int k = 0; k < PairLanes::width; k += 2) {  // two in a cache line
        __builtin_prefetch(&p.now.compact_rows[std::max(read, 0) + k], 0, into_second_level);
        __builtin_prefetch(&p.next.compact_rows[std::max(write, 0) + k], for_writing, into_second_level);
      }
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
      for (int lane = 0; lane < PairLanes::width; ++lane) {
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
        if (group.shared && lane > 0) continue;
        const WallSeat& seat = walls_.seat(g, lane / Lanes::width);
        for (std::int64_t row = seat.first_row; row < seat.first_row + seat.rows; ++row) {
          const WallEntry& entry = walls_.row(row)[lane % Lanes::width];
          const double overlap = wall_overlap(entry, first.position, in.growth.scale * first.radius);
          if (beyond(overlap, i)) return Offence{p.id[i], -1 - static_cast<std::int64_t>(entry.body), overlap};
        }
      }
    }
    return std::nullopt;
  }

  /// Below 0 where they do not touch [m].
  double wall_overlap(const WallEntry& entry, const Vec3& position, double radius) const {
    constexpr double apart = -1;
    if (!entry.there() || !boundaries_[entry.body].present) return apart;
    const Boundaries::Body& body = boundaries_[entry.body];
    std::int8_t side = entry.side;
    Touch touch;
    const Vec3 image = position - boundaries_.shift_vector(entry.shift);
    return body.shape.touch(entry.piece, body.inside(image), radius, side, touch) ? radius - touch.distance : apart;
  }

  static simd::Vector<double> total_of(const simd::Vector<typename PairLanes::Real>& v) {
    using simd::sum;
    return {sum(v.x), sum(v.y), sum(v.z)};
  }

  static simd::Vector<typename Lanes::Real> widened_part(const simd::Vector<typename PairLanes::Real>& v, int part) {
    return {PairLanes::widened(v.x, part), PairLanes::widened(v.y, part), PairLanes::widened(v.z, part)};
  }

  /// Forces from the particles in the group's rows.
  template <bool record, bool alike>
  [[gnu::always_inline]] Loads<PairLanes> pair_loads(const Particles& p, const Precision& seen,
                                                     const NeighbourGroup& group, const Bodies<PairLanes>& self,
                                                     const StepInput& in, Recorder* recorder, LaneSums<Lanes>& sums,
                                                     BlockResult& result) {
    using simd::any, simd::fused, simd::inverse_sqrt;
    using Real = typename PairLanes::Real;
    Loads<PairLanes> loads{simd::Vector<Real>::zero(), simd::Vector<Real>::zero()};
    ContactSums<Real> pairs;  // of this group, in registers
    const Real scale(in.growth.scale);
    const auto laws_of_alike = forces_.template laws_of_alike<PairLanes>(self);
    const Real range(forces_.range());
    for (std::int64_t row = group.first_row; row < group.first_row + group.rows; ++row) {
      const std::uint32_t* neighbour = list_.row(row);
      Bodies<PairLanes> other;
      const simd::Vector<Real> d = seen.template separation<alike>(self, neighbour, group.images, other.radius);
      const Real reach = scale * (self.radius + other.radius);
      const Real squared = squared_length(d);
      const Real farthest = Normal::attracts ? reach + range : reach;
      const auto near = squared < farthest * farthest;
      if (!any(near)) {
        if (remembers()) history_.pairs.none(row);
        continue;
      }
      seen.template read_motion<alike, Tangential::active>(self, neighbour, other);
      const Real inverse_distance = inverse_sqrt(squared);
      const auto touching = Normal::attracts ? squared < reach * reach : near;
      const Place<PairLanes, TurnsRound<PairLanes>> at{
          touching,          near, d, inverse_distance, Precision::overlap(reach, squared, inverse_distance),
          {inverse_distance}};
      const auto slots = [&](int lane) {
        return std::pair{group.shared ? group.slot : group.slot + lane, NeighbourList::slot(neighbour[lane])};
      };
      const auto who = [&](int lane) {
        const auto [first, second] = slots(lane);
        return std::pair<std::int64_t, std::int64_t>{p.id[first], p.id[second]};
      };
      const auto where = [&](int lane) { return p.now.rows[slots(lane).first].position; };
      const auto add = [&](const auto& laws) __attribute__((always_inline)) {
        forces_.template add<record, alike, PairLanes>(self, other, at, laws, history_.pairs, row, who, where, in,
                                                       recorder, loads, pairs, result);
      };
      if constexpr (alike) {
        add(laws_of_alike);
      } else {
        const auto materials = [&](int lane) {
          const auto [first, second] = slots(lane);
          return std::pair{p.material[first], p.material[second]};
        };
        const Real radii = self.radius + other.radius;
        const PairSize<Real> size{self.inverse_mass + other.inverse_mass, self.radius * other.radius / radii};
        add(forces_.template laws<PairLanes>(materials, size));
      }
    }
    if constexpr (alike) pairs.deepest = fused(Real(-in.overlap_limit), self.radius, pairs.deepest);
    constexpr SumsInUse in_use{Normal::plastic, !alike, Tangential::active, record};
    if constexpr (Precision::compact) {
      for (int part = 0; part < Precision::parts; ++part) {
        sums.pairs.template add<in_use>(pairs.map([part](const Real& x) { return PairLanes::widened(x, part); }));
      }
    } else {
      sums.pairs.template add<in_use>(pairs);
    }
    return loads;
  }

  /// Adds what boundaries do, then moves or keeps the forces.
  template <bool record, class L>
  [[gnu::always_inline]] void finish(Particles& p, const Seats& seats, const WallSeat& walls,
                                     const WallLoads<Lanes>*& from_walls, const Bodies<L>& self, Loads<L> loads,
                                     const StepInput& in, Recorder* recorder, LaneSums<L>& sums) {
    if (walls.rows > 0) {
      if (from_walls->any) {
        loads.force += from_walls->force.template load<L>();
        if constexpr (Tangential::active) loads.torque += from_walls->torque.template load<L>();
      }
      ++from_walls;
    }
    if constexpr (moves) {
      move<record, Tangential::active, Precision::compact, L>(p, list_, seats, self, loads, L::mask(seats.lanes), in,
                                                              recorder, sums);
    } else {
      L::store(&p.force.x[seats.slot], loads.force.x);
      L::store(&p.force.y[seats.slot], loads.force.y);
      L::store(&p.force.z[seats.slot], loads.force.z);
    }
  }

  /// Long enough that neighbours are less than half of it apart. A power of two, or the side of a periodic box over
  /// one: so a step of it rounds to single precision in the same way in every list, or not at all.
  Vec3 period_of_places() const {
    constexpr double largest_extents = 8;  // two reach to one another, and as far again while the list serves
    const double least = largest_extents * list_.largest_extent();
    Vec3 period = Vec3::Constant(std::exp2(std::ceil(std::log2(least))));
    for (int axis = 0; axis < 3; ++axis) {
      const double side = domain_.size()[axis];
      if (domain_.periodic[axis]) period[axis] = side / std::exp2(std::max(0.0, std::floor(std::log2(side / least))));
    }
    return period;
  }

  Domain domain_;
  const Boundaries& boundaries_;
  Forces forces_;
  NeighbourList list_;
  WallList walls_;
  bool alike_ = false;
  std::size_t seen_ = 0;  ///< particles when it was looked
  ContactHistory<typename Precision::Number> history_;
  WallForces<Precision, Forces, Tangential::active> from_walls_;
  std::vector<WallLoad> wall_loads_;  ///< (boundaries)
  std::vector<BlockResult> results_;
};

}  // namespace packstone::engine
