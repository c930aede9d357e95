#include "analysis/forces/coarse_grid.hpp"

#include <algorithm>

#include "analysis/forces/kernel_shares.hpp"

namespace packstone::analysis {

namespace {

constexpr double default_cell = 2;      // in kernel widths
constexpr double cells_a_particle = 1;  // of the default cell, at most

/// Where the branch of a contact ends: at the second's centre or the boundary.
Vec3 end_of_branch(const Snapshot& snapshot, const ForceContact& contact) {
  return snapshot.position[contact.first] - contact.branch;
}

/// The domain along periodic axes, else all that the kernels reach.
BoxRegion reached_box(const Snapshot& snapshot, const ForceNetwork& network, double range) {
  BoxRegion box{snapshot.position.front(), snapshot.position.front()};
  const auto include = [&](const Vec3& p) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  };
  for (const Vec3& p : snapshot.position) include(p);
  for (const ForceContact& contact : network.contacts) include(end_of_branch(snapshot, contact));
  for (int k = 0; k < 3; ++k) {
    const bool periodic = snapshot.domain.periodic[k];
    box.min[k] = periodic ? snapshot.domain.min[k] : box.min[k] - range;
    box.max[k] = periodic ? snapshot.domain.max[k] : box.max[k] + range;
  }
  return box;
}

RegularGrid grid_of(const Snapshot& snapshot, const Context& context, const ForceNetwork& network,
                    const CoarseKernel& kernel) {
  const BoxRegion box = reached_box(snapshot, network, kernel.range());
  const double wanted = context.options.forces.coarse_cell;
  const double particles = static_cast<double>(snapshot.size());
  const double suitable = suitable_width(default_cell * kernel.width(), (box.max - box.min).prod(),
                                         cells_a_particle * particles, most_coarse_cells / 2);
  return divided(box, wanted > 0 ? wanted : suitable, most_coarse_cells, "a grid of coarse-grained fields");
}

}  // namespace

CoarseGrid coarse_grid(const Snapshot& snapshot, const Context& context, const ForceNetwork& network) {
  const double width = kernel_width(snapshot, context);
  if (snapshot.size() == 0 || !(width > 0)) return {};
  const CoarseKernel kernel(context.options.forces.kernel, width);
  CoarseGrid grid{grid_of(snapshot, context, network, kernel), {}};
  grid.sums.setZero(coarse_rows, static_cast<Eigen::Index>(grid.cells()));

  const KernelShares shares(grid, snapshot.domain.periodic, kernel);
  const auto worker = [&] { return shares; };
  const auto axis = static_cast<int>(std::max_element(grid.count.begin(), grid.count.end()) - grid.count.begin());
  const auto velocity = velocities(snapshot);
  const auto start = [&](std::uint32_t row) { return snapshot.domain.wrapped(snapshot.position[row]); };
  add_in_bands(
      snapshot.size(), grid.count[axis],
      [&](std::size_t i) {
        const double at = start(static_cast<std::uint32_t>(i))[axis];
        return shares.span(axis, at, at);
      },
      worker,
      [&](KernelShares& own, std::size_t i) {
        const ParticleColumn particle = particle_column(snapshot, velocity, i);
        own.spread(start(static_cast<std::uint32_t>(i)));
        own.for_each([&](std::size_t cell, double share) {
          grid.sums.col(static_cast<Eigen::Index>(cell)).head<particle_rows>() += share * particle;
        });
      });
  add_in_bands(
      network.size(), grid.count[axis],
      [&](std::size_t k) {
        const double from = start(network.contacts[k].first)[axis];
        return shares.span(axis, from, from - network.contacts[k].branch[axis]);
      },
      worker,
      [&](KernelShares& own, std::size_t k) {
        const ForceContact& contact = network.contacts[k];
        const Vec3 &force = snapshot.contacts->force[k], from = start(contact.first), to = from - contact.branch;
        const Mat3 whole = force * contact.branch.transpose();
        own.spread(from, to);
        own.for_each([&](std::size_t cell, double share) {
          grid.sums.col(static_cast<Eigen::Index>(cell)).segment<tensor_rows>(contact_row) += share * whole.reshaped();
        });
        if (!contact.at_wall()) return;
        own.spread(to);
        own.for_each([&](std::size_t cell, double share) {
          grid.sums.col(static_cast<Eigen::Index>(cell)).segment<3>(wall_row) += share * force;
        });
      });
  return grid;
}

}  // namespace packstone::analysis
