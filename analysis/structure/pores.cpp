// Measure "pores": how large the room between the particles is.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/measures.hpp"
#include "analysis/structure/statistics.hpp"
#include "analysis/structure/void_spheres.hpp"
#include "analysis/structure/window.hpp"
#include "core/random.hpp"

namespace packstone::analysis {

namespace {

constexpr std::uint64_t point_seed = 20260102;  // fixed: the same packing gives the same numbers
constexpr double bins_a_radius = 20;            // of the distribution, a mean radius
constexpr double most_pore_bins = 1000;

struct PoreQuantities {
  Quantity mean, median, largest, void_share;
};

PoreQuantities pore_quantities(int points) {
  const std::string sphere =
      "radius of the largest sphere around a point of the void that overlaps no particle and no boundary (pore-size "
      "function: Torquato, Random Heterogeneous Materials (2002), 2.6; curved boundaries by their facets)";
  const std::string region = fmt::format("{} uniform random points (fixed seed) in {}", points, window_definition);
  return {{.key = "pore_radius_mean",
           .label = "mean pore radius",
           .unit = "m",
           .definition = "mean over the points of the void of the " + sphere + "; " + region +
                         "; uncertainty: standard error of the points, for this packing"},
          {.key = "pore_radius_median",
           .label = "median pore radius",
           .unit = "m",
           .definition = "median of the radii of pore_radius_mean; uncertainty: half the distance of the quantiles one "
                         "standard error of their rank away"},
          {.key = "pore_radius_max",
           .label = "largest pore radius found",
           .unit = "m",
           .definition = "largest of the radii of pore_radius_mean: a lower bound of the largest pore in the window"},
          {.key = "void_fraction",
           .label = "void fraction",
           .definition = "share of the points of pore_radius_mean that lie in no particle (overlaps count once); "
                         "uncertainty: binomial, for this packing"}};
}

/// Radii at random points of the window, of those in the void, ascending.
std::vector<double> sampled_radii(const Snapshot& snapshot, const Window& window, int points) {
  const VoidSpheres spheres(snapshot);
  std::vector<double> radius(static_cast<std::size_t>(points));
#pragma omp parallel for schedule(static)
  for (int k = 0; k < points; ++k) {
    Random random(point_seed, RandomStream::pore_point, static_cast<std::uint64_t>(k));
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = random.uniform(window.min[axis], window.max[axis]);
    radius[static_cast<std::size_t>(k)] = spheres.radius_at(place);
  }
  std::erase_if(radius, [](double r) { return r <= 0; });
  std::sort(radius.begin(), radius.end());
  return radius;
}

void set_median(Quantity& median, const std::vector<double>& ascending) {
  const double n = static_cast<double>(ascending.size());
  const auto quantile = [&](double share) {
    return ascending[static_cast<std::size_t>(std::clamp(share * n, 0.0, n - 1))];
  };
  const double error = 0.5 / std::sqrt(n);  // of the rank, as a share
  median.value = quantile(0.5);
  median.uncertainty = (quantile(0.5 + error) - quantile(0.5 - error)) / 2;
}

Table distribution(const std::vector<double>& ascending, double mean_radius) {
  Table table{.key = "pore_distribution",
              .caption =
                  "Radii of pore_radius_mean: density of their distribution with its standard error (binomial), "
                  "and the share of the void's points whose radius is at least the lower limit",
              .columns = {{"lower", "m"},
                          {"upper", "m"},
                          {"points", "", ColumnFormat::integer},
                          {"density", "1/m"},
                          {"error", "1/m"},
                          {"share_above_lower"}}};
  if (ascending.empty()) return table;
  const double width = std::max(mean_radius / bins_a_radius, ascending.back() / most_pore_bins);
  const auto bins = static_cast<std::size_t>(ascending.back() / width) + 1;
  std::vector<double> points(bins, 0.0);
  for (const double r : ascending) ++points[static_cast<std::size_t>(r / width)];
  const double n = static_cast<double>(ascending.size());
  double above = n;
  for (std::size_t k = 0; k < bins; ++k) {
    const double lower = static_cast<double>(k) * width, share = points[k] / n;
    table.rows.push_back(
        {lower, lower + width, points[k], share / width, share_error(share, ascending.size()) / width, above / n});
    above -= points[k];
  }
  return table;
}

}  // namespace

MeasureResult measure_pores(const Snapshot& snapshot, const Context& context) {
  const int points = context.options.pore_points;
  PoreQuantities q = pore_quantities(points);
  const WindowOrReason found = bulk_window(snapshot, context, 0);
  std::vector<double> radii;
  std::string reason = snapshot.size() == 0 ? "no particles" : found.reason;
  if (reason.empty()) {
    radii = sampled_radii(snapshot, *found.window, points);
    const double share = static_cast<double>(radii.size()) / points;
    q.void_share.value = share;
    q.void_share.uncertainty = share_error(share, static_cast<std::size_t>(points));
    if (radii.empty()) reason = "no point lies in the void";
  } else {
    q.void_share = not_applicable(q.void_share, reason);
  }
  if (reason.empty()) {
    set_mean(q.mean, radii);
    set_median(q.median, radii);
    q.largest.value = radii.back();
  } else {
    for (Quantity* each : {&q.mean, &q.median, &q.largest}) *each = not_applicable(*each, reason);
  }
  return {.name = "pores",
          .quantities = {q.mean, q.median, q.largest, q.void_share},
          .tables = {distribution(radii, context.mean_radius)}};
}

}  // namespace packstone::analysis
