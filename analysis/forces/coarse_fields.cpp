#include "analysis/forces/coarse_fields.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/blocks.hpp"
#include "analysis/forces/coarse_sums.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr double least_thickness = 0.25;  // of a layer, in kernel widths: nothing finer is left in the fields
constexpr double level_branch = 1e-5;     // in kernel ranges: below it the mean over a branch is that of its middle

/// Calls visit(layer, share) for the layers within the kernel's range of heights from low to high; share_below(h): of
/// the kernel, or of its mean along a branch, below height h.
template <class ShareBelow, class Visit>
void spread_over_layers(const Layers& layers, double low, double high, double range, ShareBelow&& share_below,
                        Visit&& visit) {
  const double count = static_cast<double>(layers.count);
  double first = std::floor((low - range - layers.bottom) / layers.thickness);
  double last = std::floor((high + range - layers.bottom) / layers.thickness);
  if (!layers.periodic) {
    first = std::max(first, 0.0);
    last = std::min(last, count - 1);
  }
  if (!(first <= last)) return;
  auto layer = static_cast<Eigen::Index>(first - count * std::floor(first / count));
  double below = share_below(layers.bottom + layers.thickness * first);
  for (double k = first; k <= last; ++k) {
    const double next = share_below(layers.bottom + layers.thickness * (k + 1));
    visit(layer, next - below);
    below = next;
    if (++layer == static_cast<Eigen::Index>(layers.count)) layer = 0;
  }
}

using Sums = Eigen::MatrixXd;  // a column for each layer

}  // namespace

KnownFields known_fields(const Snapshot& snapshot, const ForceNetwork& network) {
  return {snapshot.has_masses(), !velocities(snapshot).empty(), network.missing.empty()};
}

double kernel_width(const Snapshot& snapshot, const Context& context) {
  const double wanted = context.options.forces.kernel_width;
  double width = wanted > 0 ? wanted : context.mean_radius;
  for (int k = 0; k < 3; ++k) {
    const double side = snapshot.domain.size()[k];
    if (!snapshot.domain.periodic[k] || width <= side) continue;
    if (wanted > 0) {
      throw InputError("the kernel's width is " + std::to_string(wanted) + " m, more than the periodic side along " +
                       axis_names[k] + ", " + std::to_string(side) + " m");
    }
    width = side;
  }
  return width;
}

Layers coarse_layers(const BedFrame& frame, const std::vector<double>& radius, const CoarseKernel& kernel, double width,
                     double thickness) {
  Layers layers = layers_over_bed(frame, radius, std::max(thickness, least_thickness * width));
  if (layers.periodic || layers.count == 0) return layers;
  const double margin = std::ceil(kernel.range() / layers.thickness);
  layers.bottom = -margin * layers.thickness;
  layers.count += 2 * static_cast<std::size_t>(margin);
  return layers;
}

std::vector<CoarseCell> coarse_profile(const Snapshot& snapshot, const BedFrame& frame, const ForceNetwork& network,
                                       const CoarseKernel& kernel, const Layers& layers) {
  const Sums zero = Sums::Zero(coarse_rows, static_cast<Eigen::Index>(layers.count));
  const auto velocity = velocities(snapshot);
  const double range = kernel.range(), extent = layers.thickness * static_cast<double>(layers.count);
  // A height far outside a periodic stack would lose its layer to rounding.
  const auto inside = [&](double height) { return layers.periodic ? std::fmod(height, extent) : height; };

  Sums sums = sum_in_blocks(snapshot.size(), zero, [&](Sums& s, std::size_t i) {
    const double z = inside(frame.height[i]);
    const auto particle = particle_column(snapshot, velocity, i);
    spread_over_layers(
        layers, z, z, range, [&](double h) { return kernel.below(h - z); },
        [&](Eigen::Index layer, double share) { s.col(layer).head<particle_rows>() += share * particle; });
  });
  sums += sum_in_blocks(network.size(), zero, [&](Sums& s, std::size_t k) {
    const ForceContact& contact = network.contacts[k];
    const Vec3& force = snapshot.contacts->force[k];
    const Mat3 moment = force * contact.branch.transpose();
    const double from = inside(frame.height[contact.first]), to = from - frame.sign * contact.branch[frame.axis];
    const double low = std::min(from, to), high = std::max(from, to), rise = high - low;
    const auto along_branch = [&](double h) {
      if (rise < level_branch * range) return kernel.below(h - 0.5 * (low + high));
      return (kernel.below_integral(h - low) - kernel.below_integral(h - high)) / rise;
    };
    spread_over_layers(layers, low, high, range, along_branch, [&](Eigen::Index layer, double share) {
      s.col(layer).segment<tensor_rows>(contact_row) += share * moment.reshaped();
    });
    if (!contact.at_wall()) return;
    spread_over_layers(
        layers, to, to, range, [&](double h) { return kernel.below(h - to); },
        [&](Eigen::Index layer, double share) { s.col(layer).segment<3>(wall_row) += share * force; });
  });

  std::vector<CoarseCell> cells(layers.count);
  for (std::size_t k = 0; k < layers.count; ++k) {
    cells[k] = coarse_cell(sums.col(static_cast<Eigen::Index>(k)), frame.area * layers.thickness);
  }
  return cells;
}

}  // namespace packstone::analysis
