#include "analysis/segregation/centres.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::analysis {

std::vector<Vec3> centres_of(std::span<const Vec3> position, std::span<const std::int32_t> label,
                             std::span<const double> amount, std::size_t species) {
  std::vector<Vec3> centres(species, Vec3::Zero());
  std::vector<double> total(species, 0.0);
  for (std::size_t i = 0; i < position.size(); ++i) {
    const auto s = static_cast<std::size_t>(label[i]);
    centres[s] += amount[i] * position[i];
    total[s] += amount[i];
  }
  for (std::size_t s = 0; s < species; ++s) {
    if (total[s] > 0) centres[s] /= total[s];
  }
  return centres;
}

double extent_along(const std::vector<Vec3>& centres, int axis) {
  const auto [low, high] = std::minmax_element(centres.begin(), centres.end(),
                                               [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  return (*high)[axis] - (*low)[axis];
}

double farthest_apart(const std::vector<Vec3>& centres, const std::array<bool, 3>& periodic) {
  double farthest = 0;
  for (std::size_t a = 0; a < centres.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      Vec3 apart = centres[a] - centres[b];
      for (int k = 0; k < 3; ++k) apart[k] = periodic[static_cast<std::size_t>(k)] ? 0 : apart[k];
      farthest = std::max(farthest, apart.norm());
    }
  }
  return farthest;
}

double coordinate_variance(std::span<const Vec3> position, std::span<const double> amount, int axis) {
  if (position.size() < 2) return 0;
  double total = 0, mean = 0, variance = 0;
  const double n = static_cast<double>(position.size());
  for (const double a : amount) total += a;
  for (std::size_t i = 0; i < position.size(); ++i) mean += amount[i] / total * position[i][axis];
  for (std::size_t i = 0; i < position.size(); ++i) {
    const double off = position[i][axis] - mean;
    variance += amount[i] / total * off * off;
  }
  return variance * n / (n - 1);
}

}  // namespace packstone::analysis
