// How forces are distributed over the contacts, and how much of the friction they use.
#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/blocks.hpp"
#include "analysis/forces/friction.hpp"
#include "analysis/forces/histogram.hpp"
#include "analysis/forces/parts.hpp"

namespace packstone::analysis {

namespace {

struct Loads {
  std::vector<double> normal, tangential;  // (M) [N]
};

Loads loads_of(const Contacts& contacts) {
  Loads loads{std::vector<double>(contacts.size()), std::vector<double>(contacts.size())};
#pragma omp parallel for
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    loads.normal[k] = normal_force(contacts, k);
    loads.tangential[k] = tangential_force(contacts, k);
  }
  return loads;
}

struct CountedSum {
  double count = 0, sum = 0;
  CountedSum& operator+=(const CountedSum& other) {
    count += other.count;
    sum += other.sum;
    return *this;
  }
  void add(double value) {
    ++count;
    sum += value;
  }
};

double mean_of(std::span<const double> values) {
  const auto all = sum_in_blocks(values.size(), CountedSum{}, [&](auto& s, std::size_t k) { s.add(values[k]); });
  return all.sum / all.count;
}

struct ForceQuantities {
  Quantity mean{
      .key = "normal_force_mean",
      .label = "mean normal force",
      .unit = "N",
      .definition = "mean of F.n over all stored contacts with particles and boundaries; pressing is positive"};
  Quantity largest{.key = "normal_force_max",
                   .label = "largest normal force",
                   .unit = "N",
                   .definition = "largest F.n of a stored contact; pressing is positive"};
  Quantity tangential{.key = "tangential_force_mean",
                      .label = "mean tangential force",
                      .unit = "N",
                      .definition = "mean of |F - (F.n) n| over all stored contacts"};
  Quantity tail{.key = "normal_force_tail",
                .label = "decay rate of large normal forces",
                .definition =
                    "beta of P(x) ~ exp(-beta x) for x = F.n / normal_force_mean > 1, by maximum likelihood: "
                    "beta = n / sum (x - 1) over the n contacts above the mean; uncertainty: its standard error, "
                    "beta / sqrt(n), as if contacts were independent"};
  Quantity sliding{.key = "sliding_share",
                   .label = "share of sliding contacts",
                   .definition = "share of the stored contacts whose friction is at its Coulomb limit"};
  Quantity ratio{.key = "friction_ratio_mean",
                 .label = "mean tangential over normal force",
                 .definition = "mean of |F - (F.n) n| / F.n over the stored contacts that press (F.n > 0)"};
  Quantity mobilised{.key = "friction_mobilised_mean",
                     .label = "mean mobilised friction",
                     .definition =
                         "mean of |F - (F.n) n| / (mu F.n), 1 at Coulomb's limit, over the stored contacts that press "
                         "(F.n > 0) and whose mu > 0; mu = sqrt(mu_a mu_b) of the scene's materials"};

  std::vector<Quantity*> all() { return {&mean, &largest, &tangential, &tail, &sliding, &ratio, &mobilised}; }
};

void set_tail(Quantity& tail, std::span<const double> normal, double mean) {
  if (!(mean > 0)) {
    tail = not_applicable(tail, "the mean normal force does not press");
    return;
  }
  const auto excess = sum_in_blocks(normal.size(), CountedSum{}, [&](auto& s, std::size_t k) {
    if (normal[k] > mean) s.add(normal[k] / mean - 1);
  });
  if (!(excess.sum > equal_forces * excess.count)) {
    tail = not_applicable(tail, "no normal force above the mean");
    return;
  }
  tail.value = excess.count / excess.sum;
  tail.uncertainty = *tail.value / std::sqrt(excess.count);
}

void set_friction(Quantity& ratio, Quantity& mobilised, const Loads& loads, const Snapshot& snapshot,
                  const ForceNetwork& network) {
  const auto all = sum_in_blocks(network.size(), CountedSum{}, [&](auto& s, std::size_t k) {
    if (loads.normal[k] > 0) s.add(loads.tangential[k] / loads.normal[k]);
  });
  if (all.count == 0) {
    for (Quantity* q : {&ratio, &mobilised}) *q = not_applicable(*q, "no contact presses");
    return;
  }
  ratio.value = all.sum / all.count;
  const FrictionTable friction = friction_table(snapshot);
  if (!friction.missing.empty()) {
    mobilised = not_applicable(mobilised, friction.missing);
    return;
  }
  const auto used = sum_in_blocks(network.size(), CountedSum{}, [&](auto& s, std::size_t k) {
    const double mu = friction.coefficient(snapshot, network.contacts[k], k);
    if (loads.normal[k] > 0 && mu > 0) s.add(loads.tangential[k] / (mu * loads.normal[k]));
  });
  if (used.count > 0) {
    mobilised.value = used.sum / used.count;
  } else {
    mobilised = not_applicable(mobilised, "no contact that presses has friction");
  }
}

Table force_table(const std::string& kind, std::span<const double> values, double mean) {
  return histogram(
      {.key = kind + "_force_distribution", .caption = "Stored contacts by " + kind + " force f over its mean <f>"},
      values, mean);
}

}  // namespace

void add_force_distribution(MeasureResult& result, const Snapshot& snapshot, const ForceNetwork& network) {
  ForceQuantities q;
  Loads loads;
  if (!network.missing.empty()) {
    for (Quantity* each : q.all()) *each = not_applicable(*each, network.missing);
  } else {
    loads = loads_of(*snapshot.contacts);
    q.mean.value = mean_of(loads.normal);
    q.largest.value = *std::max_element(loads.normal.begin(), loads.normal.end());
    q.tangential.value = mean_of(loads.tangential);
    const auto& slid = snapshot.contacts->sliding;
    if (slid.empty()) {
      q.sliding = not_applicable(q.sliding, "the file does not say which contacts slide");
    } else {
      q.sliding.value =
          static_cast<double>(std::count(slid.begin(), slid.end(), 1)) / static_cast<double>(network.size());
    }
    set_tail(q.tail, loads.normal, *q.mean.value);
    set_friction(q.ratio, q.mobilised, loads, snapshot, network);
  }
  for (Quantity* each : q.all()) result.quantities.push_back(*each);
  result.tables.push_back(force_table("normal", loads.normal, q.mean.value.value_or(0)));
  result.tables.push_back(force_table("tangential", loads.tangential, q.tangential.value.value_or(0)));
}

}  // namespace packstone::analysis
