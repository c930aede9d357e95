#include "analysis/mean_diameter.hpp"

namespace packstone::analysis {

double volume_mean_diameter(std::span<const double> radius) {
  double fourth = 0, third = 0;
  for (const double r : radius) {
    third += r * r * r;
    fourth += r * r * r * r;
  }
  return third > 0 ? 2 * fourth / third : 0;
}

}  // namespace packstone::analysis
