// How many contacts the particles have, with whom, and which hold nothing.
#include <algorithm>
#include <cmath>

#include "analysis/adjacency.hpp"
#include "analysis/species.hpp"
#include "analysis/structure/parts.hpp"
#include "analysis/structure/rattlers.hpp"
#include "analysis/structure/statistics.hpp"

namespace packstone::analysis {

namespace {

/// Contacts of every particle.
struct Counts {
  std::vector<int> particles;      // (N) with particles
  std::vector<int> all;            // (N) with particles and boundaries
  std::vector<int> backbone = {};  // of the particles that are no rattlers, in order of rows: among themselves
};

/// Contacts with each other of the particles that are no rattlers.
std::vector<int> backbone_contacts(const Adjacency& near, const std::vector<char>& rattler) {
  std::vector<int> backbone;
  for (std::size_t i = 0; i < rattler.size(); ++i) {
    if (rattler[i]) continue;
    const auto others = near.of(i);
    backbone.push_back(
        static_cast<int>(std::count_if(others.begin(), others.end(), [&](std::uint32_t j) { return !rattler[j]; })));
  }
  return backbone;
}

Counts counted(const ContactNetwork& contacts, const Adjacency& near, std::size_t particles) {
  Counts counts{.particles = particle_contacts(contacts, particles), .all = all_contacts(contacts, particles)};
  counts.backbone = backbone_contacts(near, rattlers(near, counts.all));
  return counts;
}

struct CoordinationQuantities {
  Quantity mean, walls, backbone, rattlers;
};

CoordinationQuantities coordination_quantities(const std::string& note) {
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
       .definition = "contacts with particles a particle, both partners no rattlers (see rattler_fraction); "
                     "uncertainty as for coordination_mean",
       .note = note},
      {.key = "rattler_fraction",
       .label = "share of rattlers",
       .definition = "share of the particles taken away when those with fewer than 4 contacts (d + 1 in 3D, boundaries "
                     "counted; the least that can hold a frictionless sphere) are removed until none is left",
       .note = note}};
}

void add_means(MeasureResult& result, const Counts& counts, const std::string& note) {
  CoordinationQuantities q = coordination_quantities(note);
  const std::size_t particles = counts.particles.size();
  if (particles == 0) {
    for (Quantity* each : {&q.mean, &q.walls, &q.backbone, &q.rattlers}) *each = not_applicable(*each, "no particles");
  } else {
    set_mean(q.mean, counts.particles);
    set_mean(q.walls, counts.all);
    q.rattlers.value = 1 - static_cast<double>(counts.backbone.size()) / static_cast<double>(particles);
    if (counts.backbone.empty()) {
      q.backbone = not_applicable(q.backbone, "every particle is a rattler");
    } else {
      set_mean(q.backbone, counts.backbone);
    }
  }
  for (const Quantity& each : {q.mean, q.walls, q.backbone, q.rattlers}) result.quantities.push_back(each);
}

void add_numbers(MeasureResult& result, const ContactNetwork& contacts) {
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

Table distribution(const Counts& counts) {
  Table table{.key = "coordination_distribution",
              .caption =
                  "Particles by their number of contacts with particles; with those with boundaries counted "
                  "too; and without rattlers, contacts among the rest",
              .columns = {{"contacts", "", ColumnFormat::integer},
                          {"particles", "", ColumnFormat::integer},
                          {"share"},
                          {"particles_with_walls", "", ColumnFormat::integer},
                          {"share_with_walls"},
                          {"particles_without_rattlers", "", ColumnFormat::integer},
                          {"share_without_rattlers"}}};
  if (counts.all.empty()) return table;
  const auto most = static_cast<std::size_t>(*std::max_element(counts.all.begin(), counts.all.end()));
  table.rows.assign(most + 1, std::vector<double>(table.columns.size(), 0.0));
  for (std::size_t c = 0; c <= most; ++c) table.rows[c][0] = static_cast<double>(c);
  std::size_t column = 1;
  for (const std::vector<int>* each : {&counts.particles, &counts.all, &counts.backbone}) {
    for (const int c : *each) ++table.rows[static_cast<std::size_t>(c)][column];
    for (auto& row : table.rows) {
      row[column + 1] = row[column] / std::max(1.0, static_cast<double>(each->size()));
    }
    column += 2;
  }
  return table;
}

Table by_types(const Snapshot& snapshot, const Adjacency& near) {
  const SpeciesList list = species_of(snapshot);
  Table table{.key = "coordination_by_types",
              .caption =
                  "Contacts of a particle of type a with particles of type b, mean over the particles of type a "
                  "and its standard error (standard deviation over sqrt(particles)); types: " +
                  list.legend(),
              .columns = {{"type_a", "", ColumnFormat::integer},
                          {"type_b", "", ColumnFormat::integer},
                          {"particles_a", "", ColumnFormat::integer},
                          {"contacts"},
                          {"error"}}};
  const std::size_t types = list.size();
  std::vector<double> sum(types * types, 0.0), squares(types * types, 0.0);
  std::vector<double> own(types, 0.0);  // contacts of one particle by type
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    const std::size_t row = static_cast<std::size_t>(list.label[i]) * types;
    for (const std::uint32_t j : near.of(i)) ++own[static_cast<std::size_t>(list.label[j])];
    for (const std::uint32_t j : near.of(i)) {
      double& contacts = own[static_cast<std::size_t>(list.label[j])];
      sum[row + static_cast<std::size_t>(list.label[j])] += contacts;
      squares[row + static_cast<std::size_t>(list.label[j])] += contacts * contacts;
      contacts = 0;
    }
  }
  for (std::size_t a = 0; a < types; ++a) {
    const double n = static_cast<double>(list.species[a].count);
    for (std::size_t b = 0; b < types; ++b) {
      const double mean = sum[a * types + b] / n;
      const double variance = std::max(0.0, (squares[a * types + b] - n * mean * mean) / (n - 1));
      table.rows.push_back({static_cast<double>(list.species[a].type), static_cast<double>(list.species[b].type), n,
                            mean, n > 1 ? std::sqrt(variance / n) : no_value});
    }
  }
  return table;
}

}  // namespace

void add_coordination(MeasureResult& result, const Snapshot& snapshot, const Context& context) {
  const ContactNetwork& contacts = context.contacts;
  const Adjacency near = adjacency(contacts.pairs, snapshot.size());
  const Counts counts = counted(contacts, near, snapshot.size());
  add_means(result, counts, contacts.source());
  add_numbers(result, contacts);
  result.tables.push_back(distribution(counts));
  result.tables.push_back(by_types(snapshot, near));
}

}  // namespace packstone::analysis
