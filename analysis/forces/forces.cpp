// Measure "forces": what the contacts carry.
#include <algorithm>

#include "analysis/forces/parts.hpp"
#include "analysis/measures.hpp"

namespace packstone::analysis {

namespace {

void add_overlaps(MeasureResult& result, const Context& context) {
  Quantity mean{.key = "overlap_mean",
                .label = "mean overlap",
                .definition = "mean overlap of all contacts with particles and boundaries, over the mean radius"};
  Quantity largest{.key = "overlap_max",
                   .label = "largest overlap",
                   .definition = "largest overlap of a contact with a particle or boundary, over the mean radius"};
  const ContactNetwork& contacts = context.contacts;
  double sum = 0, most = 0;
  const auto add = [&](double overlap) {
    sum += overlap;
    most = std::max(most, overlap);
  };
  for (const auto& pair : contacts.pairs) add(pair.overlap);
  for (const auto& wall : contacts.walls) add(wall.overlap);
  const std::size_t count = contacts.pairs.size() + contacts.walls.size();
  for (Quantity* q : {&mean, &largest}) {
    q->note = contacts.source();
    if (count == 0) {
      *q = not_applicable(*q, "no contacts");
    } else if (!(context.mean_radius > 0)) {
      *q = not_applicable(*q, "all radii are 0");
    }
  }
  if (count > 0 && context.mean_radius > 0) {
    mean.value = sum / static_cast<double>(count) / context.mean_radius;
    largest.value = most / context.mean_radius;
  }
  result.quantities.push_back(mean);
  result.quantities.push_back(largest);
}

}  // namespace

MeasureResult measure_forces(const Snapshot& snapshot, const Context& context) {
  MeasureResult result{.name = "forces"};
  const ForceNetwork network = force_network(snapshot);
  add_force_distribution(result, snapshot, network);
  add_overlaps(result, context);
  add_stress(result, snapshot, context, network);
  add_coarse_fields(result, snapshot, context, network);
  add_force_chains(result, snapshot, context, network);
  add_cores(result, snapshot, context);
  return result;
}

}  // namespace packstone::analysis
