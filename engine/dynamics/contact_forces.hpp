// What contacts do to the bodies that touch, several contacts side by side, whatever lists found them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/contact/pair_table.hpp"
#include "engine/dynamics/contact_history.hpp"
#include "engine/dynamics/lane_sums.hpp"
#include "engine/dynamics/step.hpp"
#include "engine/simd/vector.hpp"

namespace packstone::engine {

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

/// How the normal of a contact turns as one particle goes round another.
template <class L>
struct TurnsRound {
  using Vector = simd::Vector<typename L::Real>;
  typename L::Real inverse_distance;  ///< of the centres [1/m]

  /// The normal some time before [s], of n now; across: relative velocity across it.
  [[gnu::always_inline]] Vector before(double lag, const Vector& across, const Vector& n) const {
    using Real = typename L::Real;
    return fused(Real(-lag) * inverse_distance, across, n);
  }
};

/// Contacts of each lane with one body.
template <class L, class Turning>
struct Place {
  using Real = typename L::Real;
  typename L::Mask touching;
  typename L::Mask near;                 ///< touching, or within the range of an attraction
  const simd::Vector<Real>& separation;  ///< from the second body to the first
  Real inverse_distance;                 ///< 1/|separation|
  Real overlap;
  Turning turning;  ///< of the normal
};

/// One lane as a vector of numbers.
template <class L>
Vec3 lane_of(const simd::Vector<typename L::Real>& v, int lane) {
  return {L::lane(v.x, lane), L::lane(v.y, lane), L::lane(v.z, lane)};
}

/// What is known of a contact law at the start of a run.
template <class Law>
Law made_law(const ContactSpec& contact) {
  if constexpr (std::is_constructible_v<Law, const ContactSpec&>) {
    return Law(contact);
  } else {
    return Law{};
  }
}

template <class Normal, class Tangential>
class ContactForces {
 public:
  /// Whether contacts may keep anything from step to step.
  static constexpr int most_kept = Normal::most_kept + Tangential::most_kept;
  static constexpr bool may_remember = most_kept > 0;

  ContactForces(const ContactSpec& contact, const std::vector<MaterialSpec>& materials)
      : normal_law_(made_law<Normal>(contact)),
        tangential_law_(made_law<Tangential>(contact)),
        normal_(contact, materials),
        tangential_(contact, materials) {}

  /// The material that contacts between alike particles have on both sides.
  void set_material_of_alike(std::int32_t material) {
    pair_of_alike_ = static_cast<std::size_t>(material) * (normal_.materials() + 1);
  }

  /// Numbers that a contact keeps.
  int kept() const { return normal_law_.kept() + tangential_law_.kept(); }

  /// Gap up to which bodies act on each other [m].
  double range() const {
    if constexpr (Normal::attracts) return normal_law_.attraction().range();
    return 0;
  }

  /// What the laws know of a pair, apart from its contact.
  template <class L>
  struct Laws {
    typename Normal::template Coefficients<typename L::Real> normal;
    typename Tangential::template Coefficients<typename L::Real> tangential;
    PairSize<typename L::Real> size;
  };
  /// Between alike bodies.
  template <class L>
  [[gnu::always_inline]] Laws<L> laws_of_alike(const Bodies<L>& one) const {
    using Real = typename L::Real;
    const PairSize<Real> size{one.inverse_mass + one.inverse_mass, Real(0.5) * one.radius};
    return {Normal::coefficients(common_parameters<L>(normal_), size),
            Tangential::coefficients(common_parameters<L>(tangential_), size), size};
  }
  /// materials(lane): of the pair.
  template <class L, class Materials>
  [[gnu::always_inline]] Laws<L> laws(const Materials& materials, const PairSize<typename L::Real>& size) const {
    return {Normal::coefficients(parameters<L>(normal_, materials), size),
            Tangential::coefficients(parameters<L>(tangential_, materials), size), size};
  }

  /// Adds the forces and torques of some contacts on the first bodies. who(lane): pair of ids, -1-k for boundary k;
  /// where(lane): the first body's position, for the record.
  /// Alike bodies do not grow; for them sums.deepest is the overlap itself.
  template <bool record, bool alike, class L, class Turning, class Number, class Who, class Where>
  [[gnu::always_inline]] void add(const Bodies<L>& first, const Bodies<L>& second, const Place<L, Turning>& at,
                                  const Laws<L>& laws, ContactMemory<Number>& memory, std::int64_t row, const Who& who,
                                  const Where& where, const StepInput& in, Recorder* recorder, Loads<L>& loads,
                                  ContactSums<typename L::Real>& sums, BlockResult& result) const {
    using simd::bits, simd::fused, simd::fused_where, simd::larger, simd::only;
    using Real = typename L::Real;
    const simd::Vector<Real> relative = first.velocity - second.velocity;
    const Real approach = at.inverse_distance * dot(relative, at.separation);
    const Real growth_rate = alike ? Real(0.0) : Real(in.growth.rate) * (first.radius + second.radius);
    const Real rate = alike ? -approach : growth_rate - approach;
    std::array<Real, Normal::most_kept> kept_by_normal{};
    std::array<Real, Tangential::most_kept> kept_by_tangential{};
    const int normal_count = normal_law_.kept(), tangential_count = tangential_law_.kept();
    const int count = normal_count + tangential_count;
    if (may_remember && count > 0) {
      memory.template load<L>(row, count, 0, normal_count, kept_by_normal);
      memory.template load<L>(row, count, normal_count, tangential_count, kept_by_tangential);
    }
    const NormalForce<Real> normal = normal_law_.force(laws.normal, at.overlap, rate, kept_by_normal);
    const Real repulsion = normal.total();
    Real total = repulsion;
    [[maybe_unused]] Real pull = 0.0;
    [[maybe_unused]] typename L::Mask attracted = at.near;
    if constexpr (Normal::attracts) {
      if (range() > 0) {
        pull = only(at.near, normal_law_.attraction().force(laws.size.effective_radius, -at.overlap));
        total = only(at.touching, repulsion) - pull;
      } else {
        attracted = at.touching;
      }
    }
    loads.force = fused_where(attracted, total * at.inverse_distance, at.separation, loads.force);
    sums.damping_power = fused_where(at.touching, normal.damping, rate, sums.damping_power);
    if constexpr (Normal::plastic) sums.plastic_loss += only(at.touching, normal.loss);
    if constexpr (alike) {
      sums.deepest = larger(at.overlap, sums.deepest);
    } else {
      sums.deepest = larger(fused(Real(-in.overlap_limit), first.radius, at.overlap), sums.deepest);
      if (in.growth.rate != 0) sums.growth_power = fused_where(attracted, total, growth_rate, sums.growth_power);
    }
    [[maybe_unused]] const simd::Vector<Real> n = at.inverse_distance * at.separation;
    [[maybe_unused]] simd::Vector<Real> tangential_force = simd::Vector<Real>::zero();
    [[maybe_unused]] std::uint32_t sliding = 0;
    [[maybe_unused]] Real elastic = 0.0;
    if constexpr (record) elastic = normal_law_.energy(laws.normal, at.overlap, kept_by_normal);
    if constexpr (Tangential::active) {
      // Lever arms at the instant's radii; the sum has the same bits seen from either body.
      const simd::Vector<Real> spin =
          Real(in.growth.scale) * (first.radius * first.angular_velocity + second.radius * second.angular_velocity);
      // Velocities that lag go with the normal of their own instant: else rolling adds to springs what makes small
      // spheres stick between large ones (Vyas et al., Comput. Phys. Commun. 310 (2025) 109524).
      const simd::Vector<Real> across = fused(-approach, n, relative);
      const simd::Vector<Real> normal_then = at.turning.before(in.velocity_lag(), across, n);
      const simd::Vector<Real> contact_velocity = relative - cross(spin, normal_then);
      const simd::Vector<Real> sliding_velocity = fused(-dot(contact_velocity, n), n, contact_velocity);
      const Slip<Real> slip{n, sliding_velocity, repulsion, at.overlap, in.dt};
      const auto friction = tangential_law_.advance(laws.tangential, slip, kept_by_tangential);
      tangential_force = friction.force;
      loads.force = fused_where(at.touching, Real(1.0), friction.force, loads.force);
      loads.torque =
          fused_where(at.touching, Real(-in.growth.scale) * first.radius, cross(n, friction.force), loads.torque);
      sums.sliding_loss = fused_where(at.touching, Real(1.0), friction.dissipated, sums.sliding_loss);
      elastic += friction.elastic;
      sliding = bits(friction.sliding);
    }
    if (may_remember && count > 0) {
      memory.template store<L>(row, count, 0, normal_count, kept_by_normal);
      memory.template store<L>(row, count, normal_count, tangential_count, kept_by_tangential);
      memory.template touch<L>(row, at.touching);
    }
    if constexpr (record) {
      sums.elastic += only(at.touching, elastic);
      if constexpr (Normal::attracts) {
        if (range() > 0) {
          const Real potential = normal_law_.attraction().energy(laws.size.effective_radius, -at.overlap);
          sums.attractive += only(at.near, potential);
        }
      }
      for (std::uint32_t lanes = bits(at.touching); lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        const auto [a, b] = who(lane);
        const Vec3 direction = lane_of<L>(n, lane);
        const double overlap = L::lane(at.overlap, lane), radius = L::lane(first.radius, lane);
        result.sums.largest_overlap_share = std::max(result.sums.largest_overlap_share, overlap / radius);
        if (!recorder->elastic.empty()) {
          recorder->elastic[static_cast<std::size_t>(a)] += (b < 0 ? 1.0 : 0.5) * L::lane(elastic, lane);
        }
        if (b >= 0 && b < a) continue;
        ++(b < 0 ? result.sums.wall_contacts : result.sums.particle_contacts);
        if (!recorder->want_contacts) continue;
        Contacts& c = result.contacts;
        c.first.push_back(a);
        c.second.push_back(b);
        c.force.push_back(L::lane(total, lane) * direction + lane_of<L>(tangential_force, lane));
        c.normal.push_back(direction);
        c.overlap.push_back(overlap);
        c.point.push_back(where(lane) - (in.growth.scale * radius - 0.5 * overlap) * direction);
        c.sliding.push_back((sliding >> lane & 1u) != 0);
      }
    }
  }

 private:
  /// A law's parameters for each lane's pair of materials.
  template <class L, class Law, class Materials>
  [[gnu::always_inline]] auto parameters(const PairTable<Law>& table, const Materials& materials) const {
    if (table.materials() == 1) return common_parameters<L>(table);
    return looked_up<L>(table, materials);
  }

  /// The same in all lanes.
  template <class L, class Law>
  [[gnu::always_inline]] auto common_parameters(const PairTable<Law>& table) const {
    using Real = typename L::Real;
    return parameters_from<typename Law::template Parameters<Real>>(
        [&](int k) { return Real(table.table(k)[pair_of_alike_]); });
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
    return parameters_from<Parameters>([&](int k) { return L::gather(table.table(k), pair); });
  }

  Normal normal_law_;
  Tangential tangential_law_;
  PairTable<Normal> normal_;
  PairTable<Tangential> tangential_;
  std::size_t pair_of_alike_ = 0;
};

}  // namespace packstone::engine
