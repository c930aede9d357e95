// What boundaries do to the particles of a block.
#pragma once

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include <omp.h>

#include "engine/dynamics/contact_forces.hpp"
#include "engine/dynamics/contact_history.hpp"
#include "engine/dynamics/lane_sums.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/precision.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/dynamics/wall_contacts.hpp"

namespace packstone::engine {

/// Forces: ContactForces of the scene's laws; turning: whether anything turns. What it is made with must outlive it.
template <class Precision, class Forces, bool turning>
class WallForces {
  using Lanes = typename Precision::Lanes;

 public:
  WallForces(const Domain& domain, const Boundaries& boundaries, const Forces& forces, const NeighbourList& list,
             WallList& walls, ContactMemory<double>& memory)
      : domain_(domain), boundaries_(boundaries), forces_(forces), list_(list), walls_(walls), memory_(memory) {}

  /// For the list's blocks and all threads; after the lists were built.
  void make_room() {
    sides_.resize(static_cast<std::size_t>(omp_get_max_threads()));
    block_loads_.resize(list_.blocks().size() * boundaries_.size());
  }

  /// At the start of a step.
  void start() { std::fill(block_loads_.begin(), block_loads_.end(), WallLoad{}); }

  /// (boundaries) loads of all blocks, added in order.
  void sum_up(std::vector<WallLoad>& loads) const {
    std::fill(loads.begin(), loads.end(), WallLoad{});
    for (std::size_t k = 0; k < block_loads_.size(); ++k) loads[k % boundaries_.size()].add(block_loads_[k]);
  }

  /// Of the block that this thread has found the forces of, one for each seat that has rows of walls.
  const WallLoads<Lanes>* found() { return own_side().loads.data(); }

  /// Forces on all of a block's particles, before the loop over its groups: a call in there would cost it all its
  /// registers. Returns whether a contact is beyond the overlap limit.
  template <bool record>
  [[gnu::noinline]] bool find(Particles& p, std::ptrdiff_t block, const StepInput& in, Recorder* recorder,
                              BlockResult& result) {
    LaneSums<Lanes> sums;
    LaneSums<simd::Scalar> alone_sums;
    const DoublePrecision<Lanes> rows(p, domain_);
    const DoublePrecision<simd::Scalar> single_rows(p, domain_);
    const GroupBlock& groups = list_.blocks()[block];
    Side& side = own_side();
    side.used = 0;
    const std::size_t most = static_cast<std::size_t>(groups.last - groups.first) * Precision::parts;
    if (side.loads.size() < most) side.loads.resize(most);
    for (std::int32_t g = groups.first; g < groups.last; ++g) {
      const NeighbourGroup& group = list_.groups()[g];
      if (group.shared) {
        if (walls_.seat(g, 0).rows == 0) continue;
        wall_forces<record>(p, block, Seats{group.slot, 1}, walls_.seat(g, 0),
                            single_rows.template bodies_in_line<turning>(group.slot), in, recorder, side,
                            alone_sums.walls, result);
        continue;
      }
      for (int part = 0; part < Precision::parts; ++part) {
        if (walls_.seat(g, part).rows == 0) continue;
        const Seats seats = seats_of<Lanes>(group, part);
        wall_forces<record>(p, block, seats, walls_.seat(g, part), rows.template bodies_in_line<turning>(seats.slot),
                            in, recorder, side, sums.walls, result);
      }
    }
    sums.add_to(result, in);
    alone_sums.add_to(result, in);
    return sums.beyond_limit() || alone_sums.beyond_limit();
  }

 private:
  /// What one thread needs; kept from step to step.
  struct alignas(64) Side {
    WallContacts<Lanes> contacts;
    std::vector<WallLoads<Lanes>> loads;  ///< of a block's seats that have rows of walls
    std::size_t used = 0;                 ///< of loads
  };
  Side& own_side() { return sides_[static_cast<std::size_t>(omp_get_thread_num())]; }

  [[gnu::always_inline]] bool remembers() const { return Forces::may_remember && forces_.kept() > 0; }

  template <bool record, class L>
  void wall_forces(Particles& p, std::ptrdiff_t block, const Seats& seats, const WallSeat& seat, const Bodies<L>& self,
                   const StepInput& in, Recorder* recorder, Side& side, ContactSums<typename L::Real>& sums,
                   BlockResult& result) {
    using Real = typename L::Real;
    WallContacts<Lanes>& contacts = side.contacts;
    WallLoads<Lanes>& kept = side.loads[side.used++];
    WallLoad* loads_on_walls = block_loads_.data() + static_cast<std::size_t>(block) * boundaries_.size();
    Loads<L> loads{simd::Vector<Real>::zero(), simd::Vector<Real>::zero()};
    const bool turns = turning && in.velocity_lag() > 0;
    const VectorArray& then = list_.reference();
    const simd::Vector<Real> moved =
        self.position -
        simd::Vector<Real>{L::load(&then.x[seats.slot]), L::load(&then.y[seats.slot]), L::load(&then.z[seats.slot])};
    contacts.template find<L>(boundaries_, walls_, seat, seats.lanes, self, moved, in.growth.scale, forces_.range(),
                              turns);
    if constexpr (Forces::may_remember) {
      if (remembers()) {
        contacts.template pass_on<Forces::most_kept>(walls_, seat, seats.lanes, forces_.kept(), memory_);
      }
    }
    kept.any = contacts.any_near();
    for (int k = 0; k < seat.rows; ++k) {
      const WallRow<Lanes>& found = contacts.row(k);
      const std::int64_t row = seat.first_row + k;
      if (found.near == 0) {
        if (remembers()) memory_.none(row);
        continue;
      }
      const WallEntry* entries = walls_.row(row);
      const Bodies<L> wall{self.position, Real(0.0), found.velocity.template load<L>(), Real(0.0),
                           simd::Vector<Real>::zero()};
      const simd::Vector<Real> normal = found.normal.template load<L>();
      const Place<L, TurnsAlong<L>> at{
          L::mask(found.touching),           L::mask(found.near), normal, Real(1.0), L::load(found.overlap.data()),
          {found.turning.template load<L>()}};
      const auto who = [&](int lane) {
        return std::pair<std::int64_t, std::int64_t>{p.id[seats.slot + lane], -1 - std::int64_t{entries[lane].body}};
      };
      const auto where = [&](int lane) { return p.now.rows[seats.slot + lane].position; };
      const auto materials = [&](int lane) {
        return std::pair{p.material[seats.slot + lane], boundaries_[entries[lane].body].material};
      };
      const auto laws = forces_.template laws<L>(materials, PairSize<Real>{self.inverse_mass, self.radius});
      const simd::Vector<Real> before = loads.force;
      forces_.template add<record, false, L>(self, wall, at, laws, memory_, row, who, where, in, recorder, loads, sums,
                                             result);
      const simd::Vector<Real> added = loads.force - before;
      for (std::uint32_t lanes = found.near; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        const Vec3 force = lane_of<L>(added, lane);
        loads_on_walls[entries[lane].body].add({-force, force.dot(found.velocity.get(lane))});
      }
    }
    if (!kept.any) return;
    kept.force.template store<L>(loads.force);
    kept.torque.template store<L>(loads.torque);
  }

  Domain domain_;
  const Boundaries& boundaries_;
  const Forces& forces_;
  const NeighbourList& list_;
  WallList& walls_;
  ContactMemory<double>& memory_;
  std::vector<Side> sides_;            ///< one a thread
  std::vector<WallLoad> block_loads_;  ///< (blocks, boundaries)
};

}  // namespace packstone::engine
