// The bond-orientational order as quantities and a table.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/structure/bond_order.hpp"
#include "analysis/structure/parts.hpp"
#include "analysis/structure/statistics.hpp"
#include "core/bed.hpp"

namespace packstone::analysis {

namespace {

constexpr std::size_t distribution_bins = 50;  // of q over [0, 1]

/// Values of the particles in the bulk that have a neighbour.
struct BulkValues {
  std::vector<double> q4, q6, averaged_q4, averaged_q6;
  std::vector<int> neighbours;
  std::size_t particles = 0;  // in the bulk, with neighbour or without
  std::size_t crystalline = 0;
};

std::vector<char> in_bulk(const Context& context) {
  const BedFrame& frame = context.frame;
  std::vector<char> chosen(frame.height.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const double share = frame.height[i] / context.bed.height;
    chosen[i] = frame.periodic || (share >= bulk_lower && share <= bulk_upper);
  }
  return chosen;
}

BulkValues values_of(const BondOrder& order, const Bonds& bonds, const std::vector<char>& chosen) {
  BulkValues bulk;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (!chosen[i]) continue;
    ++bulk.particles;
    if (bonds.of(i).empty()) continue;
    bulk.neighbours.push_back(static_cast<int>(bonds.of(i).size()));
    bulk.q4.push_back(order.q4[i]);
    bulk.q6.push_back(order.q6[i]);
    bulk.averaged_q4.push_back(order.averaged_q4[i]);
    bulk.averaged_q6.push_back(order.averaged_q6[i]);
    if (order.solid_bonds[i] >= solid_bonds_of_crystal) ++bulk.crystalline;
  }
  return bulk;
}

std::string neighbour_definition(const Options& options) {
  return options.bond_neighbours > 0
             ? fmt::format("the {} nearest by centres", options.bond_neighbours)
             : fmt::format("those with centres nearer than {:g} times the sum of the radii", options.bond_cutoff);
}

struct OrderQuantities {
  Quantity neighbours, q4, q6, averaged_q4, averaged_q6, global_q4, global_q6, crystalline;
};

OrderQuantities order_quantities(const Options& options) {
  const std::string bulk =
      "particles between 10 % and 80 % of the bed's height (all, where the domain is periodic along "
      "up) that have a neighbour; neighbours: " +
      neighbour_definition(options);
  const std::string error = "; uncertainty: standard deviation over sqrt(N), as if particles were independent";
  const std::string steinhardt = " (Steinhardt, Nelson, Ronchetti, Phys. Rev. B 28 (1983) 784)";
  const std::string lechner = " (Lechner, Dellago, J. Chem. Phys. 129 (2008) 114707)";
  const auto local = [&](const std::string& l) {
    return "mean over the " + bulk + ", of q" + l + "(i) = sqrt(4 pi/(2l + 1) sum_m |q_lm(i)|^2), l = " + l +
           ", q_lm(i) = mean of Y_lm over the neighbours" + steinhardt + error;
  };
  const auto averaged = [&](const std::string& l) {
    return "as q" + l + "_mean, with q_lm averaged over the particle and its neighbours first" + lechner + error;
  };
  const auto global = [&](const std::string& l) {
    return "Q" + l + " = sqrt(4 pi/(2l + 1) sum_m |<Y_lm>|^2), l = " + l + ", mean over all bonds of the " + bulk +
           steinhardt +
           "; uncertainty: 1/sqrt(bonds), each seen from both ends, the root mean square of Q for independent "
           "isotropic bonds";
  };
  return {{.key = "bond_neighbours_mean",
           .label = "mean number of neighbours, for bond order",
           .definition = "mean over the " + bulk + error},
          {.key = "q4_mean", .label = "mean local bond order q4", .definition = local("4")},
          {.key = "q6_mean", .label = "mean local bond order q6", .definition = local("6")},
          {.key = "q4_averaged_mean", .label = "mean averaged bond order q4", .definition = averaged("4")},
          {.key = "q6_averaged_mean", .label = "mean averaged bond order q6", .definition = averaged("6")},
          {.key = "q4_global", .label = "global bond order Q4", .definition = global("4")},
          {.key = "q6_global", .label = "global bond order Q6", .definition = global("6")},
          {.key = "crystalline_fraction",
           .label = "crystalline share",
           .definition = fmt::format("share of the particles of the bulk with at least {} solid bonds: neighbours with "
                                     "sum_m q_6m(i) q_6m*(j) > {} |q_6(i)| |q_6(j)| (after ten Wolde, Ruiz-Montero, "
                                     "Frenkel, J. Chem. Phys. 104 (1996) 9932); bulk and neighbours as for q6_mean; "
                                     "uncertainty: binomial, as if particles were independent",
                                     solid_bonds_of_crystal, solid_product)}};
}

Table order_distribution(const BulkValues& bulk) {
  Table table{
      .key = "bond_order_distribution",
      .caption =
          "Share of the particles by bond order; particles, neighbours and q as for q6_mean and "
          "q6_averaged_mean",
      .columns = {{"lower"}, {"upper"}, {"share_q4"}, {"share_q6"}, {"share_q4_averaged"}, {"share_q6_averaged"}}};
  if (bulk.q4.empty()) return table;
  const double width = 1.0 / static_cast<double>(distribution_bins);
  for (std::size_t k = 0; k < distribution_bins; ++k) {
    table.rows.push_back({static_cast<double>(k) * width, static_cast<double>(k + 1) * width, 0, 0, 0, 0});
  }
  const double each = 1 / static_cast<double>(bulk.q4.size());
  std::size_t column = 2;
  for (const auto* values : {&bulk.q4, &bulk.q6, &bulk.averaged_q4, &bulk.averaged_q6}) {
    for (const double q : *values) {
      const auto bin = std::min(static_cast<std::size_t>(q / width), distribution_bins - 1);
      table.rows[bin][column] += each;
    }
    ++column;
  }
  return table;
}

}  // namespace

void add_bond_order(MeasureResult& result, const Snapshot& snapshot, const Context& context) {
  const Options& options = context.options;
  const Bonds bonds = chosen_bonds(snapshot, options);
  const std::vector<char> chosen = in_bulk(context);
  const BondOrder order = bond_order(snapshot, bonds, chosen);
  const BulkValues bulk = values_of(order, bonds, chosen);

  OrderQuantities q = order_quantities(options);
  if (bulk.q4.empty()) {
    const std::string reason = bulk.particles == 0 ? "no particles in the bulk" : "no particle has a neighbour";
    for (Quantity* each : {&q.neighbours, &q.q4, &q.q6, &q.averaged_q4, &q.averaged_q6, &q.global_q4, &q.global_q6}) {
      *each = not_applicable(*each, reason);
    }
  } else {
    set_mean(q.neighbours, bulk.neighbours);
    set_mean(q.q4, bulk.q4);
    set_mean(q.q6, bulk.q6);
    set_mean(q.averaged_q4, bulk.averaged_q4);
    set_mean(q.averaged_q6, bulk.averaged_q6);
    q.global_q4.value = order.global_q4;
    q.global_q6.value = order.global_q6;
    for (Quantity* each : {&q.global_q4, &q.global_q6}) each->uncertainty = std::sqrt(2 / order.bond_ends);
  }
  if (bulk.particles == 0) {
    q.crystalline = not_applicable(q.crystalline, "no particles in the bulk");
  } else {
    q.crystalline.value = static_cast<double>(bulk.crystalline) / static_cast<double>(bulk.particles);
    q.crystalline.uncertainty = share_error(*q.crystalline.value, bulk.particles);
  }
  for (const Quantity& each :
       {q.neighbours, q.q4, q.q6, q.averaged_q4, q.averaged_q6, q.global_q4, q.global_q6, q.crystalline}) {
    result.quantities.push_back(each);
  }
  result.tables.push_back(order_distribution(bulk));
}

}  // namespace packstone::analysis
