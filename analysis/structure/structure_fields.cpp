// Contacts and bond order of every particle.
#include "analysis/measures.hpp"
#include "analysis/structure/bond_order.hpp"
#include "analysis/structure/rattlers.hpp"

namespace packstone::analysis {

namespace {

/// An order that a particle without neighbours does not have.
std::vector<double> with_neighbours(std::vector<double> order, const Bonds& bonds) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (bonds.of(i).empty()) order[i] = no_value;
  }
  return order;
}

std::vector<double> neighbour_counts(const Bonds& bonds) {
  std::vector<double> counts;
  for (std::size_t i = 0; i + 1 < bonds.begin.size(); ++i) counts.push_back(static_cast<double>(bonds.of(i).size()));
  return counts;
}

}  // namespace

std::vector<ParticleField> structure_fields(const Snapshot& snapshot, const Context& context) {
  const std::size_t n = snapshot.size();
  const std::vector<int> contacts = all_contacts(context.contacts, n);
  const Bonds bonds = chosen_bonds(snapshot, context.options);
  BondOrder order = bond_order(snapshot, bonds, std::vector<char>(n, 0));
  const auto averaged = [](const std::string& l) {
    return "q" + l +
           " with q_lm averaged over the particle and its neighbours first (Lechner, Dellago, J. Chem. Phys. "
           "129 (2008) 114707)";
  };
  const std::string local =
      " = sqrt(4 pi/(2l + 1) sum_m |q_lm|^2), q_lm the mean of Y_lm over the neighbours of q6_mean; none without "
      "neighbour (Steinhardt, Nelson, Ronchetti, Phys. Rev. B 28 (1983) 784)";
  return {{.name = "coordination",
           .definition = "contacts with particles",
           .values = as_values(particle_contacts(context.contacts, n))},
          {.name = "coordination_with_walls",
           .definition = "contacts with particles and boundaries",
           .values = as_values(contacts)},
          {.name = "rattler",
           .definition = "1 for the particles of rattler_fraction, else 0",
           .values = as_values(rattlers(adjacency(context.contacts.pairs, n), contacts))},
          {.name = "bond_neighbours", .definition = "neighbours of the bond order", .values = neighbour_counts(bonds)},
          {.name = "q4",
           .definition = "local bond order q_l, l = 4," + local,
           .values = with_neighbours(std::move(order.q4), bonds)},
          {.name = "q6",
           .definition = "local bond order q_l, l = 6," + local,
           .values = with_neighbours(std::move(order.q6), bonds)},
          {.name = "q4_averaged",
           .definition = averaged("4"),
           .values = with_neighbours(std::move(order.averaged_q4), bonds)},
          {.name = "q6_averaged",
           .definition = averaged("6"),
           .values = with_neighbours(std::move(order.averaged_q6), bonds)},
          {.name = "solid_bonds",
           .definition = "solid bonds of crystalline_fraction, which counts the particles with 7 or more",
           .values = as_values(order.solid_bonds)}};
}

}  // namespace packstone::analysis
