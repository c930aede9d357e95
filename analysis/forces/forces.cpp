// Measure "forces": what the contacts carry.
#include <algorithm>

#include "analysis/measures.hpp"

namespace packstone::analysis {

namespace {

struct ForceSum {
  double mean = 0, largest = 0;  // normal, pressing positive [N]
  double sliding_share = 0;
};

ForceSum summed(const Contacts& contacts) {
  const double n = static_cast<double>(contacts.size());
  ForceSum sum;
  sum.largest = contacts.force[0].dot(contacts.normal[0]);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double normal = contacts.force[k].dot(contacts.normal[k]);
    sum.mean += normal / n;
    sum.largest = std::max(sum.largest, normal);
    if (!contacts.sliding.empty()) sum.sliding_share += contacts.sliding[k] / n;
  }
  return sum;
}

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
    if (count == 0) *q = not_applicable(*q, "no contacts");
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
  Quantity mean{
      .key = "normal_force_mean",
      .label = "mean normal force",
      .unit = "N",
      .definition = "mean of F.n over all stored contacts with particles and boundaries; pressing is positive"};
  Quantity largest{.key = "normal_force_max",
                   .label = "largest normal force",
                   .unit = "N",
                   .definition = "largest F.n of a stored contact; pressing is positive"};
  Quantity sliding{.key = "sliding_share",
                   .label = "share of sliding contacts",
                   .definition = "share of the stored contacts whose friction is at its Coulomb limit"};
  if (snapshot.contacts && snapshot.contacts->size() > 0) {
    const ForceSum sum = summed(*snapshot.contacts);
    mean.value = sum.mean;
    largest.value = sum.largest;
    if (snapshot.contacts->sliding.empty()) {
      sliding = not_applicable(sliding, "the file does not say which contacts slide");
    } else {
      sliding.value = sum.sliding_share;
    }
  } else {
    const std::string reason = snapshot.contacts ? "no contacts" : "the snapshot holds no contact forces";
    for (Quantity* q : {&mean, &largest, &sliding}) *q = not_applicable(*q, reason);
  }
  MeasureResult result{.name = "forces", .quantities = {mean, largest, sliding}};
  add_overlaps(result, context);
  return result;
}

}  // namespace packstone::analysis
