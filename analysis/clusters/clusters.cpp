// Measure "clusters": groups of touching particles of one type.
#include <array>
#include <map>
#include <numeric>

#include "analysis/measures.hpp"
#include "analysis/relabelling.hpp"
#include "analysis/species.hpp"
#include "analysis/union_find.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

/// The numbers of one labelling, in the order of the output.
enum Number : std::size_t { count, count_of_several, largest, mean_size, mean_size_by_mass, like_share, number_count };

const char* const random_model = "random permutations of the types among the particles of the same contact network";

std::array<Quantity, number_count> cluster_quantities() {
  std::array<Quantity, number_count> q;
  q[count] = {.key = "count",
              .label = "clusters",
              .definition = "groups of particles of one type connected by contacts, single particles included"};
  q[count_of_several] = {.key = "count_of_several",
                         .label = "clusters of two or more",
                         .definition = "clusters of at least two particles"};
  q[largest] = {.key = "largest", .label = "largest cluster", .definition = "particles of the largest cluster"};
  q[mean_size] = {.key = "mean_size",
                  .label = "mean cluster size",
                  .definition = "particles a cluster, every cluster counted once, single particles included"};
  q[mean_size_by_mass] = {.key = "mean_size_by_mass",
                          .label = "mean cluster size, by mass",
                          .definition =
                              "sum of mass times size over sum of mass of all clusters: particles in the "
                              "cluster in which an average kilogram lies"};
  q[like_share] = {.key = "like_contact_share",
                   .label = "share of like contacts",
                   .definition = "contacts between particles of one type over all contacts between particles"};
  return q;
}

UnionFind clusters_of(const ContactNetwork& contacts, std::span<const std::int32_t> label) {
  UnionFind sets(label.size());
  for (const auto& pair : contacts.pairs) {
    if (label[pair.first] == label[pair.second]) sets.join(pair.first, pair.second);
  }
  return sets;
}

std::vector<double> cluster_numbers(const ContactNetwork& contacts, std::span<const std::int32_t> label,
                                    const SpeciesList& list, const std::vector<double>& volume) {
  UnionFind sets = clusters_of(contacts, label);
  std::vector<double> numbers(number_count, 0.0);
  double mass = 0, mass_times_size = 0;
  for (std::uint32_t i = 0; i < label.size(); ++i) {
    const std::uint32_t root = sets.root(i);
    const double size = sets.size(root), m = list.species[static_cast<std::size_t>(label[i])].density * volume[i];
    mass += m;
    mass_times_size += m * size;
    numbers[largest] = std::max(numbers[largest], size);
    if (root != i) continue;
    ++numbers[count];
    if (size > 1) ++numbers[count_of_several];
  }
  double like = 0;
  for (const auto& pair : contacts.pairs) like += label[pair.first] == label[pair.second] ? 1 : 0;
  numbers[mean_size] = static_cast<double>(label.size()) / numbers[count];
  numbers[mean_size_by_mass] = mass > 0 ? mass_times_size / mass : 0;
  numbers[like_share] = contacts.pairs.empty() ? 0 : like / static_cast<double>(contacts.pairs.size());
  return numbers;
}

Table size_table(const ContactNetwork& contacts, const SpeciesList& list) {
  UnionFind sets = clusters_of(contacts, list.label);
  std::map<std::pair<std::int32_t, std::uint32_t>, std::size_t> clusters;  // by type and size
  for (std::uint32_t i = 0; i < list.label.size(); ++i) {
    if (sets.root(i) != i) continue;
    ++clusters[{list.species[static_cast<std::size_t>(list.label[i])].type, sets.size(i)}];
  }
  Table table{.key = "sizes",
              .caption = "Clusters by type (" + list.legend() + ") and number of particles",
              .columns = {{"type", "", ColumnFormat::integer},
                          {"size", "", ColumnFormat::integer},
                          {"clusters", "", ColumnFormat::integer}}};
  for (const auto& [key, clusters_of_size] : clusters) {
    table.rows.push_back(
        {static_cast<double>(key.first), static_cast<double>(key.second), static_cast<double>(clusters_of_size)});
  }
  return table;
}

std::string number_note(const ContactNetwork& contacts, const SpeciesList& list) {
  std::string note = contacts.source();
  if (list.size_linked()) {
    note += (note.empty() ? "" : "; ");
    note += "types differ in size: random labels put types on particles of other sizes";
  }
  return note;
}

/// Empty when the number exists.
std::string reason_against(Number number, const std::vector<double>& numbers, const Snapshot& snapshot,
                           const ContactNetwork& contacts) {
  if (number == like_share && contacts.pairs.empty()) return "no contacts between particles";
  const bool weighed = snapshot.has_masses() && numbers[mean_size_by_mass] > 0;
  if (number == mean_size_by_mass && !weighed) return "the particles have no mass: a density or a radius is not known";
  return "";
}

}  // namespace

MeasureResult measure_clusters(const Snapshot& snapshot, const Context& context) {
  MeasureResult result{.name = "clusters"};
  auto quantities = cluster_quantities();
  const SpeciesList list = species_of(snapshot);
  if (list.label.empty()) {
    for (const auto& q : quantities) add_without_reference(result, not_applicable(q, "no particles"), "no particles");
    return result;
  }
  std::vector<double> volume;
  for (double r : snapshot.radius) volume.push_back(sphere_volume(r));
  const auto numbers_of = [&](std::span<const std::int32_t> label) {
    return cluster_numbers(context.contacts, label, list, volume);
  };
  const auto numbers = numbers_of(list.label);
  std::vector<RandomReference> references;
  if (list.size() > 1) references = over_random_labels(list.label, permutation_count(snapshot.size()), numbers_of);

  for (std::size_t k = 0; k < number_count; ++k) {
    Quantity& q = quantities[k];
    q.note = number_note(context.contacts, list);
    const std::string missing = reason_against(static_cast<Number>(k), numbers, snapshot, context.contacts);
    if (!missing.empty()) {
      add_without_reference(result, not_applicable(q, missing), missing);
      continue;
    }
    q.value = numbers[k];
    if (references.empty()) {
      add_without_reference(result, q, "the packing has one type of particle only");
    } else {
      add_with_reference(result, q, references[k], random_model);
    }
  }
  result.tables.push_back(size_table(context.contacts, list));
  return result;
}

}  // namespace packstone::analysis
