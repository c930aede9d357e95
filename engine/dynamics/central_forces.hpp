// Central forces of one normal law; each is compiled in a file of its own, central_forces_LAW.cpp.
#pragma once

#include <array>
#include <bit>
#include <memory>
#include <vector>

#include "engine/contact/frictionless.hpp"
#include "engine/dynamics/force_field.hpp"
#include "engine/dynamics/newtonian_step.hpp"
#include "engine/dynamics/precision.hpp"
#include "engine/simd/lanes.hpp"

namespace packstone::engine {

/// Exponent: a std::ratio, of the overlap in the law's force.
template <class Normal, class Exponent>
class CentralForces final : public ForceField {
  using Lanes = simd::Widest;
  using Scalar = simd::Scalar;

 public:
  CentralForces(const Scene& scene, const Domain& domain, const Boundaries& boundaries)
      : domain_(domain),
        boundaries_(boundaries),
        law_(made_law<Normal>(scene.contact)),
        step_(scene, domain, boundaries) {}

  void rebuild(Particles& particles, const Growth& growth, double dt, double least_share) override {
    step_.rebuild(particles, growth, dt, least_share);
  }
  StepSums find(Particles& particles, const StepInput& input, Recorder* recorder) override {
    return step_.advance(particles, input, recorder);
  }
  void archive(Archive& a, Particles& particles) override { step_.archive(a, particles); }
  NeighbourList& neighbours() override { return step_.list(); }
  const WallList& walls() override { return step_.walls(); }
  const std::vector<WallLoad>& wall_loads() const override { return step_.wall_loads(); }

  void linearise(const Particles& particles, double scale, ContactMatrix& matrix) override {
    const auto count = static_cast<std::ptrdiff_t>(step_.list().blocks().size());
    matrix.blocks().resize(static_cast<std::size_t>(count));
#pragma omp parallel for schedule(dynamic) num_threads(useful_threads(particles.size()))
    for (std::ptrdiff_t b = 0; b < count; ++b) {
      ContactMatrix::Block& block = matrix.blocks()[b];
      block.entries.clear();
      block.ends.clear();
      block.energy = 0;
      WallContacts<Lanes> contacts;
      const GroupBlock& groups = step_.list().blocks()[b];
      for (std::int32_t g = groups.first; g < groups.last; ++g) linearise(particles, scale, g, contacts, block);
    }
  }

 private:
  using Entry = ContactMatrix::Entry;
  static constexpr double exponent = static_cast<double>(Exponent::num) / Exponent::den;

  void linearise(const Particles& p, double scale, std::int32_t g, WallContacts<Lanes>& contacts,
                 ContactMatrix::Block& block) {
    const NeighbourGroup& group = step_.list().groups()[g];
    std::array<std::vector<Entry>, Lanes::width> at_walls;
    double pairs = 0, walls = 0;  // stored in them [J]
    const WallSeat& seat = step_.walls().seat(g, 0);
    if (seat.rows > 0) {
      walls = group.shared ? find_walls<Scalar>(p, Seats{group.slot, 1}, seat, scale, contacts, at_walls)
                           : find_walls<Lanes>(p, seats_of<Lanes>(group, 0), seat, scale, contacts, at_walls);
    }
    for (int lane = 0; lane < (group.shared ? 1 : Lanes::width); ++lane) {
      const std::int32_t slot = group.slot + lane;
      if (!p.is_particle(slot)) continue;
      for (std::int64_t row = group.first_row; row < group.first_row + group.rows; ++row) {
        for (int k = group.shared ? 0 : lane; k < (group.shared ? Lanes::width : lane + 1); ++k) {
          pairs += add_pair(p, scale, slot, NeighbourList::slot(step_.list().row(row)[k]), block.entries);
        }
      }
      block.entries.insert(block.entries.end(), at_walls[lane].begin(), at_walls[lane].end());
      block.ends.emplace_back(slot, static_cast<std::int32_t>(block.entries.size()));
    }
    block.energy += 0.5 * pairs + walls;
  }

  /// What the contact stores [J].
  double add_pair(const Particles& p, double scale, std::int32_t i, std::int32_t j, std::vector<Entry>& entries) const {
    if (!p.is_particle(j)) return 0;
    const Row &one = p.now.rows[i], &other = p.now.rows[j];
    const Vec3 d = domain_.separation(one.position, other.position);
    const double reach = scale * (one.radius + other.radius), squared = d.squaredNorm();
    if (!(squared < reach * reach)) return 0;
    const double distance = std::sqrt(squared), overlap = reach - distance;
    if (!(overlap > 0)) return 0;  // they just touch: rounding
    const PairSize<double> size{one.inverse_mass + other.inverse_mass,
                                one.radius * other.radius / (one.radius + other.radius)};
    const double force = force_of(p.material[i], p.material[j], size, overlap);
    entries.push_back({j, d / distance, exponent * force / overlap});
    return force * overlap / (exponent + 1);
  }

  double force_of(std::int32_t a, std::int32_t b, const PairSize<double>& size, double overlap) const {
    const auto laws = step_.forces().template laws<Scalar>([&](int) { return std::pair{a, b}; }, size);
    std::array<double, Normal::most_kept> none{};
    return law_.force(laws.normal, overlap, 0.0, none).elastic;
  }

  /// What they store [J].
  template <class L>
  double find_walls(const Particles& p, const Seats& seats, const WallSeat& seat, double scale,
                    WallContacts<Lanes>& contacts, std::array<std::vector<Entry>, Lanes::width>& found) {
    const DoublePrecision<L> rows(p, domain_);
    const auto self = rows.template bodies_in_line<false>(seats.slot);
    const VectorArray& then = step_.list().reference();
    const simd::Vector<typename L::Real> moved =
        self.position - simd::Vector<typename L::Real>{L::load(&then.x[seats.slot]), L::load(&then.y[seats.slot]),
                                                       L::load(&then.z[seats.slot])};
    contacts.template find<L>(boundaries_, step_.walls(), seat, seats.lanes, self, moved, scale, 0, false);
    double energy = 0;
    for (int k = 0; k < seat.rows; ++k) {
      const WallRow<Lanes>& row = contacts.row(k);
      for (std::uint32_t lanes = row.touching; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        if (!(row.overlap[lane] > 0)) continue;  // it just touches
        const std::int32_t slot = seats.slot + lane;
        const WallEntry& entry = step_.walls().row(seat.first_row + k)[lane];
        const Row& particle = p.now.rows[slot];
        const double force = force_of(p.material[slot], boundaries_[entry.body].material,
                                      {particle.inverse_mass, particle.radius}, row.overlap[lane]);
        found[lane].push_back({ContactMatrix::wall, row.normal.get(lane), exponent * force / row.overlap[lane]});
        energy += force * row.overlap[lane] / (exponent + 1);
      }
    }
    return energy;
  }

  Domain domain_;
  const Boundaries& boundaries_;
  Normal law_;
  NewtonianStep<DoublePrecision<Lanes>, Normal, Frictionless, false> step_;
};

}  // namespace packstone::engine
