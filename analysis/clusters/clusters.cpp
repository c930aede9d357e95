// Measure "clusters": groups of particles that touch, are near, or press hard on each other.
#include <array>
#include <map>

#include "analysis/clusters/cluster_links.hpp"
#include "analysis/clusters/cluster_shapes.hpp"
#include "analysis/measures.hpp"
#include "analysis/relabelling.hpp"
#include "analysis/species.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

/// The numbers of one labelling, in the order of the output.
enum Number : std::size_t {
  count,
  count_of_several,
  largest,
  mean_size,
  mean_size_by_mass,
  percolating_share,
  like_share,
  number_count
};

constexpr std::size_t most_shapes = 20;  // rows of the table of the largest

const char* const random_model = "random permutations of the types among the particles of the same network";

/// What one labelling is measured with.
struct Network {
  const Snapshot& snapshot;
  ClusterLinks links;
  std::vector<std::uint8_t> ends;
  std::vector<double> volume;
  SpeciesList list;
  bool any_type;

  ImageSets clusters(std::span<const std::int32_t> label) const {
    return joined_clusters(links, any_type ? std::span<const std::int32_t>() : label, snapshot.size());
  }
};

std::array<Quantity, number_count> cluster_quantities(const std::string& who) {
  std::array<Quantity, number_count> q;
  q[count] = {.key = "count",
              .label = "clusters",
              .definition = "groups of particles connected by pairs " + who + ", single particles included"};
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
  q[percolating_share] = {
      .key = "percolating_share",
      .label = "share of particles in clusters right through",
      .definition =
          "share of the particles whose cluster reaches through the packing along any axis: meets its own "
          "image (periodic axes; Newman & Ziff, Phys. Rev. E 64 (2001) 016706), or is within a mean radius "
          "of both ends of the packing (along up: of floor and bed_height)"};
  q[like_share] = {.key = "like_contact_share",
                   .label = "share of like contacts",
                   .definition = "pairs of particles of one type over all pairs of the network"};
  return q;
}

std::vector<double> cluster_numbers(const Network& network, std::span<const std::int32_t> label) {
  ImageSets sets = network.clusters(label);
  const Percolation percolation(sets, network.ends, network.snapshot.domain);
  std::vector<double> numbers(number_count, 0.0);
  double mass = 0, mass_times_size = 0;
  for (std::uint32_t i = 0; i < label.size(); ++i) {
    const std::uint32_t root = sets.find(i).root;
    const double size = sets.size(root);
    const double m = network.list.species[static_cast<std::size_t>(label[i])].density * network.volume[i];
    mass += m;
    mass_times_size += m * size;
    numbers[largest] = std::max(numbers[largest], size);
    if (root != i) continue;
    ++numbers[count];
    if (size > 1) ++numbers[count_of_several];
    if (percolation.along_any(root)) numbers[percolating_share] += size / static_cast<double>(label.size());
  }
  const auto& links = network.links.links;
  double like = 0;
  for (const ClusterLink& link : links) like += label[link.first] == label[link.second] ? 1 : 0;
  numbers[mean_size] = static_cast<double>(label.size()) / numbers[count];
  numbers[mean_size_by_mass] = mass > 0 ? mass_times_size / mass : 0;
  numbers[like_share] = links.empty() ? 0 : like / static_cast<double>(links.size());
  return numbers;
}

/// Type of a cluster for the tables; none where clusters hold any.
double type_of(const Network& network, std::uint32_t root) {
  if (network.any_type) return no_value;
  return network.list.species[static_cast<std::size_t>(network.list.label[root])].type;
}

std::string legend(const Network& network) {
  return network.any_type ? "of any types" : "by type (" + network.list.legend() + ")";
}

Table size_table(const Network& network, ImageSets& sets) {
  std::map<std::pair<std::int32_t, std::uint32_t>, std::pair<double, std::size_t>> clusters;  // by label and size
  for (std::uint32_t i = 0; i < network.list.label.size(); ++i) {
    if (sets.find(i).root != i) continue;
    auto& [type, found] = clusters[{network.any_type ? 0 : network.list.label[i], sets.size(i)}];
    type = type_of(network, i);
    ++found;
  }
  Table table{.key = "sizes",
              .caption = "Clusters " + legend(network) + " and number of particles",
              .columns = {{"type", "", ColumnFormat::integer},
                          {"size", "", ColumnFormat::integer},
                          {"clusters", "", ColumnFormat::integer}}};
  for (const auto& [key, found] : clusters) {
    table.rows.push_back({found.first, static_cast<double>(key.second), static_cast<double>(found.second)});
  }
  return table;
}

Quantity gyration_quantity() {
  return {.key = "largest_gyration_radius",
          .label = "radius of gyration of the largest cluster",
          .unit = "m",
          .definition = "sqrt(sum v |x - centre|^2 / sum v) over its particles' centres, v their volumes"};
}

/// The largest clusters, and the largest one's radius of gyration.
void add_shapes(MeasureResult& result, const Network& network, ImageSets& sets) {
  const Percolation percolation(sets, network.ends, network.snapshot.domain);
  const auto shapes = largest_clusters(network.snapshot, sets, most_shapes);
  Quantity radius = gyration_quantity();
  radius.value = shapes.front().gyration_radius;
  if (!radius.value) {
    radius = not_applicable(radius, network.volume[shapes.front().root] > 0
                                        ? "the largest cluster goes round the periodic box without end"
                                        : "the particles have no volume");
  }
  result.quantities.push_back(radius);
  Table table{.key = "largest_clusters",
              .caption = "The largest clusters, at most 20, " + legend(network) +
                         ": particles, radius of gyration (none where a cluster has no end), extent of the spheres; 1 "
                         "where a cluster percolates along an axis, as for percolating_share",
              .columns = {{"type", "", ColumnFormat::integer},
                          {"size", "", ColumnFormat::integer},
                          {"gyration_radius", "m"},
                          {"extent_x", "m"},
                          {"extent_y", "m"},
                          {"extent_z", "m"},
                          {"percolates_x", "", ColumnFormat::integer},
                          {"percolates_y", "", ColumnFormat::integer},
                          {"percolates_z", "", ColumnFormat::integer}}};
  for (const ClusterShape& shape : shapes) {
    std::vector<double> row = {type_of(network, shape.root), static_cast<double>(shape.size),
                               shape.gyration_radius.value_or(no_value)};
    for (int k = 0; k < 3; ++k) row.push_back(shape.extent[k]);
    for (int k = 0; k < 3; ++k) row.push_back(percolation.along(shape.root, k) ? 1 : 0);
    table.rows.push_back(row);
  }
  result.tables.push_back(table);
}

std::string number_note(const Network& network, const ContactNetwork& contacts) {
  std::string note = contacts.source();
  if (!network.any_type && network.list.size_linked()) {
    note += (note.empty() ? "" : "; ");
    note += "types differ in size: random labels put types on particles of other sizes";
  }
  return note;
}

/// Empty when the number exists.
std::string reason_against(Number number, const std::vector<double>& numbers, const Network& network) {
  if (number == like_share && network.links.links.empty()) return "no pairs " + network.links.rule;
  const bool weighed = network.snapshot.has_masses() && numbers[mean_size_by_mass] > 0;
  if (number == mean_size_by_mass && !weighed) return "the particles have no mass: a density or a radius is not known";
  return "";
}

MeasureResult without_clusters(const std::array<Quantity, number_count>& quantities, const std::string& reason) {
  MeasureResult result{.name = "clusters"};
  for (const auto& q : quantities) add_without_reference(result, not_applicable(q, reason), reason);
  result.quantities.push_back(not_applicable(gyration_quantity(), reason));
  return result;
}

}  // namespace

MeasureResult measure_clusters(const Snapshot& snapshot, const Context& context) {
  const bool any_type = context.options.clusters.any_type;
  Network network{
      snapshot, cluster_links(snapshot, context), ends_of_particles(snapshot, context), {}, species_of(snapshot),
      any_type};
  auto quantities = cluster_quantities(network.links.rule + (any_type ? "" : " and of one type"));
  if (snapshot.size() == 0) return without_clusters(quantities, "no particles");
  if (!network.links.unavailable.empty()) return without_clusters(quantities, network.links.unavailable);
  for (double r : snapshot.radius) network.volume.push_back(sphere_volume(r));

  const auto numbers_of = [&](std::span<const std::int32_t> label) { return cluster_numbers(network, label); };
  const auto numbers = numbers_of(network.list.label);
  std::string no_reference;
  if (network.list.size() < 2) no_reference = "the packing has one type of particle only";
  if (any_type) no_reference = "clusters of any types do not depend on labels";
  std::vector<RandomReference> references;
  if (no_reference.empty()) {
    references = over_random_labels(network.list.label, permutation_count(snapshot.size()), numbers_of);
  }

  MeasureResult result{.name = "clusters"};
  for (std::size_t k = 0; k < number_count; ++k) {
    Quantity& q = quantities[k];
    q.note = number_note(network, context.contacts);
    const std::string missing = reason_against(static_cast<Number>(k), numbers, network);
    if (!missing.empty()) {
      add_without_reference(result, not_applicable(q, missing), missing);
      continue;
    }
    q.value = numbers[k];
    if (references.empty()) {
      add_without_reference(result, q, no_reference);
    } else {
      add_with_reference(result, q, references[k], random_model);
    }
  }
  ImageSets sets = network.clusters(network.list.label);
  result.tables.push_back(size_table(network, sets));
  add_shapes(result, network, sets);
  return result;
}

}  // namespace packstone::analysis
