#include "engine/filling/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/random.hpp"
#include "engine/filling/placing.hpp"

namespace packstone::engine {

namespace {

/// A lattice as a box that repeats.
struct UnitCell {
  Vec3 size;                ///< in distances of nearest sites
  std::vector<Vec3> sites;  ///< in shares of the size
};

UnitCell unit_cell(Lattice lattice) {
  const double root_2 = std::sqrt(2.0), root_3 = std::sqrt(3.0);
  switch (lattice) {
    case Lattice::bcc:
      return {Vec3::Constant(2 / root_3), {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.5)}};
    case Lattice::fcc:
      return {Vec3::Constant(root_2), {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 0, 0.5), Vec3(0, 0.5, 0.5)}};
    case Lattice::hcp:
      return {Vec3(1, root_3, 2 * root_2 / root_3),
              {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 5.0 / 6, 0.5), Vec3(0, 1.0 / 3, 0.5)}};
    case Lattice::cubic:
      break;
  }
  return {Vec3::Ones(), {Vec3(0, 0, 0)}};
}

/// All sites with room for a sphere of this radius.
std::vector<Vec3> sites_in(const Scene& scene, const Domain& domain, const Boundaries& boundaries, double radius) {
  const Region region = region_of(scene, domain);
  const UnitCell unit = unit_cell(scene.filling.lattice);
  Vec3 cell = scene.filling.spacing.value_or(2 * radius) * unit.size, first = region.min;
  int count[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double length = region.max[axis] - region.min[axis];
    const bool whole_period = domain.periodic[axis] && length == domain.size()[axis];
    constexpr double rounding = 1e-9;
    const double cells = length / cell[axis] + rounding;
    count[axis] = static_cast<int>(whole_period ? cells : cells + 1);
    if (whole_period && count[axis] > 0) cell[axis] = length / count[axis];
    if (!whole_period) first[axis] += radius;
  }
  std::vector<Vec3> sites;
  for (int i = 0; i < count[0]; ++i) {
    for (int j = 0; j < count[1]; ++j) {
      for (int k = 0; k < count[2]; ++k) {
        for (const Vec3& site : unit.sites) {
          const Vec3 p = first + (Vec3(i, j, k) + site).cwiseProduct(cell);
          if (has_room(p, radius, region, domain, boundaries)) sites.push_back(p);
        }
      }
    }
  }
  return sites;
}

}  // namespace

StartingState lattice_particles(const Scene& scene, const Domain& domain, const Boundaries& boundaries) {
  StartingState start = unplaced_particles(scene);
  const double largest = *std::max_element(start.radius.begin(), start.radius.end());
  if (scene.filling.spacing && *scene.filling.spacing < 2 * largest) {
    scene.fail("filling.spacing",
               fmt::format("{:g} m is less than the largest diameter, {:g} m: particles would overlap",
                           *scene.filling.spacing, 2 * largest));
  }
  std::vector<Vec3> sites = sites_in(scene, domain, boundaries, largest);
  if (sites.size() < start.size()) {
    scene.fail("filling", fmt::format("{} particles are asked for, the lattice has {} sites with room for the largest "
                                      "({:g} m); enlarge the region, reduce spacing or take fewer",
                                      start.size(), sites.size(), largest));
  }
  const Vec3 up = scene.gravity.present ? Vec3(-scene.gravity.acceleration) : Vec3(0, 0, 1);
  std::stable_sort(sites.begin(), sites.end(), [&](const Vec3& a, const Vec3& b) { return a.dot(up) < b.dot(up); });
  std::vector<std::size_t> order(start.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(static_cast<std::uint64_t>(scene.seed), RandomStream::filling_order, 0);
  shuffle(order, random);
  for (std::size_t k = 0; k < order.size(); ++k) start.position[order[k]] = domain.wrapped(sites[k]);
  return start;
}

}  // namespace packstone::engine
