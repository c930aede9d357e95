#include "analysis/forces/stress.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/blocks.hpp"
#include "analysis/forces/motion_sums.hpp"

namespace packstone::analysis {

namespace {

/// Calls visit(layer, share) for every layer that a vertical extent from low to high touches, with the share of the
/// extent in it; what lies outside a stack that is not periodic is left out.
template <class Visit>
void for_each_layer(const Layers& layers, double low, double high, Visit&& visit) {
  const double count = static_cast<double>(layers.count);
  if (layers.periodic) {
    const double extent = high - low;
    low = std::fmod(low, count * layers.thickness);  // a height far outside would lose its layer to rounding
    high = low + extent;
  }
  double first = std::floor((low - layers.bottom) / layers.thickness);
  double last = std::floor((high - layers.bottom) / layers.thickness);
  if (!layers.periodic) {
    first = std::max(first, 0.0);
    last = std::min(last, count - 1);
  }
  for (double k = first; k <= last; ++k) {
    const double lower = layers.bottom + layers.thickness * k;
    const double part = std::min(high, lower + layers.thickness) - std::max(low, lower);
    const double share = high > low ? std::max(part, 0.0) / (high - low) : 1;
    visit(static_cast<Eigen::Index>(k - count * std::floor(k / count)), share);
  }
}

using Sums = Eigen::MatrixXd;  // a column for each layer

Sums contact_sums(const Snapshot& snapshot, const BedFrame& frame, const ForceNetwork& network, const Layers& layers) {
  const Sums zero = Sums::Zero(tensor_rows, static_cast<Eigen::Index>(layers.count));
  return sum_in_blocks(network.size(), zero, [&](Sums& sums, std::size_t k) {
    const ForceContact& contact = network.contacts[k];
    const Mat3 moment = snapshot.contacts->force[k] * contact.branch.transpose();
    const double from = frame.height[contact.first], to = from - frame.sign * contact.branch[frame.axis];
    for_each_layer(layers, std::min(from, to), std::max(from, to),
                   [&](Eigen::Index layer, double share) { sums.col(layer) += share * moment.reshaped(); });
  });
}

Sums motion_sums(const Snapshot& snapshot, const BedFrame& frame, const Layers& layers) {
  const auto velocity = velocities(snapshot);
  const Sums zero = Sums::Zero(motion_rows, static_cast<Eigen::Index>(layers.count));
  if (velocity.empty()) return zero;
  return sum_in_blocks(snapshot.size(), zero, [&](Sums& sums, std::size_t i) {
    const double height = frame.height[i];
    const MotionColumn motion = motion_of(snapshot, velocity, i);
    for_each_layer(layers, height, height, [&](Eigen::Index layer, double) { sums.col(layer) += motion; });
  });
}

}  // namespace

PrincipalStress principal(const Mat3& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric(stress));  // ascending
  return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
}

double deviator(const Mat3& stress) {
  const Mat3 s = symmetric(stress) - pressure(stress) * Mat3::Identity();
  return std::sqrt(1.5 * s.squaredNorm());
}

std::vector<Mat3> particle_force_moments(const Snapshot& snapshot, const ForceNetwork& network) {
  std::vector<Mat3> moment(snapshot.size(), Mat3::Zero());
  for (std::size_t k = 0; k < network.size(); ++k) {
    const ForceContact& contact = network.contacts[k];
    const Mat3 whole = snapshot.contacts->force[k] * contact.branch.transpose();
    moment[contact.first] += contact.first_share * whole;
    if (!contact.at_wall()) moment[contact.second] += (1 - contact.first_share) * whole;
  }
  return moment;
}

std::vector<LayerStress> layer_stress(const Snapshot& snapshot, const BedFrame& frame, const ForceNetwork& network,
                                      const Layers& layers) {
  std::vector<LayerStress> stress(layers.count);
  const double volume = frame.area * layers.thickness;
  const Sums contact = contact_sums(snapshot, frame, network, layers);
  const Sums motion = motion_sums(snapshot, frame, layers);
  for (std::size_t k = 0; k < layers.count; ++k) {
    const auto layer = static_cast<Eigen::Index>(k);
    stress[k].contact = contact.col(layer).reshaped(3, 3) / volume;
    stress[k].kinetic = fluctuation(motion.col(layer)) / volume;
  }
  return stress;
}

std::span<const double> velocities(const Snapshot& snapshot) {
  const auto found = snapshot.fields.find("velocity");
  if (found == snapshot.fields.end() || found->second.components != 3 || !snapshot.has_masses()) return {};
  const auto& v = found->second.values;
  if (!std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); })) return {};
  return v;
}

double angle_to_vertical(const Vec3& direction, const BedFrame& frame) {
  const Vec3 up = frame.sign * Vec3::Unit(frame.axis);
  return std::atan2(direction.cross(up).norm(), std::abs(direction.dot(up))) * 180 / std::numbers::pi;
}

}  // namespace packstone::analysis
