// Periodic images of spheres, as many as a region needs.
#pragma once

#include <array>
#include <cmath>

#include "analysis/packing/region.hpp"
#include "core/domain.hpp"

namespace packstone::analysis {

/// Calls visit(centre) for every image of a sphere that can reach into the box; in an order that depends on them alone.
template <class Visit>
void for_each_image(const Domain& domain, const Vec3& centre, double radius, const BoxRegion& box, Visit&& visit) {
  std::array<double, 3> first{}, last{};  // shifts, in lengths of the domain
  for (int k = 0; k < 3; ++k) {
    const double low = box.min[k] - radius - centre[k], high = box.max[k] + radius - centre[k];
    if (domain.periodic[k]) {
      const double length = domain.max[k] - domain.min[k];
      first[k] = std::ceil(low / length);
      last[k] = std::floor(high / length);
    } else if (low > 0 || high < 0) {
      return;
    }
  }
  const Vec3 size = domain.size();
  for (double x = first[0]; x <= last[0]; ++x) {
    for (double y = first[1]; y <= last[1]; ++y) {
      for (double z = first[2]; z <= last[2]; ++z) visit(Vec3(centre + Vec3(x, y, z).cwiseProduct(size)));
    }
  }
}

}  // namespace packstone::analysis
