// Measure "structure": how many contacts the particles have.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/adjacency.hpp"
#include "analysis/measures.hpp"

namespace packstone::analysis {

namespace {

/// Fewest contacts that can hold a sphere in place: d + 1 in d = 3 dimensions, without friction.
constexpr int fewest_to_be_stable = 4;

struct Backbone {
  std::size_t particles = 0;
  double contact_ends = 0;  // particle contacts between them, twice
};

/// What remains when particles with fewer than four contacts are taken away until none is left.
Backbone without_rattlers(const ContactNetwork& contacts, const std::vector<int>& with_particles,
                          const std::vector<int>& with_walls) {
  const std::size_t n = with_particles.size();
  const Adjacency near = adjacency(contacts.pairs, n);
  std::vector<int> left(n);
  std::vector<char> removed(n, 0);
  std::vector<std::uint32_t> queue;
  const auto remove_if_loose = [&](std::size_t i) {
    if (removed[i] || left[i] >= fewest_to_be_stable) return;
    removed[i] = 1;
    queue.push_back(static_cast<std::uint32_t>(i));
  };
  for (std::size_t i = 0; i < n; ++i) left[i] = with_particles[i] + with_walls[i];
  for (std::size_t i = 0; i < n; ++i) remove_if_loose(i);
  while (!queue.empty()) {
    const std::uint32_t i = queue.back();
    queue.pop_back();
    for (const std::uint32_t other : near.of(i)) {
      --left[other];
      remove_if_loose(other);
    }
  }
  Backbone backbone;
  backbone.particles = static_cast<std::size_t>(std::count(removed.begin(), removed.end(), 0));
  for (const auto& pair : contacts.pairs) {
    if (!removed[pair.first] && !removed[pair.second]) backbone.contact_ends += 2;
  }
  return backbone;
}

/// Mean and its standard error.
void set_mean(Quantity& quantity, const std::vector<int>& values) {
  const double n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  quantity.value = mean;
  if (values.size() < 2) return;
  double squares = 0;
  for (int v : values) squares += (v - mean) * (v - mean);
  quantity.uncertainty = std::sqrt(squares / (n - 1) / n);
}

struct StructureQuantities {
  Quantity mean, walls, backbone, rattlers;
};

StructureQuantities structure_quantities(const std::string& note) {
  return {
      {.key = "coordination_mean",
       .label = "mean coordination number",
       .definition = "contacts with particles a particle, over all particles; uncertainty: standard deviation over "
                     "sqrt(N), as if particles were independent",
       .note = note},
      {.key = "coordination_with_walls",
       .label = "mean coordination number, with boundaries",
       .definition = "contacts with particles and boundaries a particle, over all particles; uncertainty as for "
                     "coordination_mean",
       .note = note},
      {.key = "coordination_without_rattlers",
       .label = "mean coordination number, without rattlers",
       .definition = "contacts with particles a particle, both partners no rattlers (see rattler_fraction)",
       .note = note},
      {.key = "rattler_fraction",
       .label = "share of rattlers",
       .definition = "share of the particles taken away when those with fewer than 4 contacts (d + 1 in 3D, boundaries "
                     "counted; the least that can hold a frictionless sphere) are removed until none is left",
       .note = note}};
}

Table distribution(const std::vector<int>& with_particles) {
  Table table{
      .key = "coordination_distribution",
      .caption = "Particles by their number of contacts with particles",
      .columns = {{"contacts", "", ColumnFormat::integer}, {"particles", "", ColumnFormat::integer}, {"share"}}};
  if (with_particles.empty()) return table;
  std::vector<std::size_t> particles(
      static_cast<std::size_t>(*std::max_element(with_particles.begin(), with_particles.end())) + 1);
  for (int c : with_particles) ++particles[static_cast<std::size_t>(c)];
  for (std::size_t c = 0; c < particles.size(); ++c) {
    const double count = static_cast<double>(particles[c]);
    table.rows.push_back({static_cast<double>(c), count, count / static_cast<double>(with_particles.size())});
  }
  return table;
}

void add_counts(MeasureResult& result, const ContactNetwork& contacts) {
  result.quantities.push_back({.key = "contact_count",
                               .label = "contacts between particles",
                               .value = static_cast<double>(contacts.pairs.size()),
                               .definition = "pairs of particles with overlap > 0, each once",
                               .note = contacts.source()});
  result.quantities.push_back({.key = "wall_contact_count",
                               .label = "contacts with boundaries",
                               .value = static_cast<double>(contacts.walls.size()),
                               .definition = "contacts of particles with boundaries, overlap > 0",
                               .note = contacts.source()});
}

}  // namespace

MeasureResult measure_structure(const Snapshot& snapshot, const Context& context) {
  const ContactNetwork& contacts = context.contacts;
  StructureQuantities q = structure_quantities(contacts.source());
  const auto with_particles = particle_contacts(contacts, snapshot.size());
  const auto with_walls = wall_contacts(contacts, snapshot.size());
  if (snapshot.size() == 0) {
    for (Quantity* each : {&q.mean, &q.walls, &q.backbone, &q.rattlers}) *each = not_applicable(*each, "no particles");
  } else {
    set_mean(q.mean, with_particles);
    std::vector<int> all(with_particles);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] += with_walls[i];
    set_mean(q.walls, all);

    const Backbone rest = without_rattlers(contacts, with_particles, with_walls);
    q.rattlers.value = 1 - static_cast<double>(rest.particles) / static_cast<double>(snapshot.size());
    if (rest.particles > 0) {
      q.backbone.value = rest.contact_ends / static_cast<double>(rest.particles);
    } else {
      q.backbone = not_applicable(q.backbone, "every particle is a rattler");
    }
  }
  MeasureResult result{.name = "structure", .quantities = {q.mean, q.walls, q.backbone, q.rattlers}};
  add_counts(result, contacts);
  result.tables.push_back(distribution(with_particles));
  return result;
}

}  // namespace packstone::analysis
