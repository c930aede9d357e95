#include "analysis/structure/bond_order.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/blocks.hpp"
#include "analysis/structure/harmonics.hpp"

namespace packstone::analysis {

namespace {

struct HarmonicsSum {
  Harmonics value{};
  double bonds = 0;

  HarmonicsSum& operator+=(const HarmonicsSum& more) {
    for (std::size_t k = 0; k < value.size(); ++k) value[k] += more.value[k];
    bonds += more.bonds;
    return *this;
  }
};

void scale(Harmonics& harmonics, double factor) {
  for (double& v : harmonics) v *= factor;
}

double length_of_4(const Harmonics& h) { return std::sqrt(product_of_4(h, h)); }
double length_of_6(const Harmonics& h) { return std::sqrt(product_of_6(h, h)); }

/// Mean harmonics over each particle's bonds.
std::vector<Harmonics> local_harmonics(const Snapshot& snapshot, const Bonds& bonds) {
  const HarmonicsRecurrence recurrence;
  std::vector<Harmonics> local(snapshot.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < snapshot.size(); ++i) {
    Harmonics sum{};
    for (const std::uint32_t j : bonds.of(i)) {
      recurrence.add(snapshot.domain.separation(snapshot.position[j], snapshot.position[i]).normalized(), sum);
    }
    scale(sum, 1 / std::max(1.0, static_cast<double>(bonds.of(i).size())));
    local[i] = sum;
  }
  return local;
}

}  // namespace

BondOrder bond_order(const Snapshot& snapshot, const Bonds& bonds, const std::vector<char>& chosen) {
  const std::size_t n = snapshot.size();
  const std::vector<Harmonics> local = local_harmonics(snapshot, bonds);
  BondOrder order;
  for (auto* values : {&order.q4, &order.q6, &order.averaged_q4, &order.averaged_q6}) values->resize(n);
  order.solid_bonds.resize(n);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    order.q4[i] = length_of_4(local[i]);
    order.q6[i] = length_of_6(local[i]);
    HarmonicsSum around{local[i]};
    for (const std::uint32_t j : bonds.of(i)) {
      around += {local[j]};
      const double lengths = order.q6[i] * length_of_6(local[j]);
      if (product_of_6(local[i], local[j]) > solid_product * lengths) ++order.solid_bonds[i];
    }
    scale(around.value, 1 / static_cast<double>(bonds.of(i).size() + 1));
    order.averaged_q4[i] = length_of_4(around.value);
    order.averaged_q6[i] = length_of_6(around.value);
  }
  HarmonicsSum all = sum_in_blocks(n, HarmonicsSum{}, [&](HarmonicsSum& sum, std::size_t i) {
    if (!chosen[i]) return;
    HarmonicsSum own{local[i], static_cast<double>(bonds.of(i).size())};
    scale(own.value, own.bonds);
    sum += own;
  });
  order.bond_ends = all.bonds;
  scale(all.value, 1 / std::max(1.0, all.bonds));
  order.global_q4 = length_of_4(all.value);
  order.global_q6 = length_of_6(all.value);
  return order;
}

}  // namespace packstone::analysis
