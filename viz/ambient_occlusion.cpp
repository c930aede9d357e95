#include "viz/ambient_occlusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace packstone::viz {

namespace {

constexpr double reaches[] = {1, 2, 4};
constexpr int directions = 8;    // of pairs, over half a turn
constexpr double longest = 128;  // [px] bounds the margin: large particles are shaded near their contacts only

double distance_of(double reaches_across, double reach) { return std::clamp(reaches_across * reach, 1.0, longest); }

inline float within_one(float x) {
  const float above = x > -1 ? x : -1;
  return above < 1 ? above : 1;
}

}  // namespace

int occlusion_margin(double reach) {
  return static_cast<int>(std::ceil(distance_of(std::end(reaches)[-1], reach))) + 1;
}

std::vector<float> nearness_of(const std::vector<float>& distances, bool parallel) {
  std::vector<float> nearness(distances.size());
  for (std::size_t k = 0; k < distances.size(); ++k) nearness[k] = parallel ? -distances[k] : 1 / distances[k];
  return nearness;
}

HollowProbe::HollowProbe(double reach, float unit_per_pixel, bool parallel, std::size_t stride) : parallel_(parallel) {
  for (const double across : reaches) {
    const double distance = distance_of(across, reach);
    for (int k = 0; k < directions; ++k) {
      const double angle = std::numbers::pi * k / directions;
      const auto x = std::lround(distance * std::cos(angle)), y = std::lround(distance * std::sin(angle));
      const auto length = static_cast<float>(std::hypot(static_cast<double>(x), static_cast<double>(y)));
      pairs_.push_back({y * static_cast<std::ptrdiff_t>(stride) + x, 1 / (length * unit_per_pixel)});
    }
  }
}

// In perspective a neighbour lies (1 / n_here - 1 / n) nearer, and a pixel takes the slope's share of the distance
// across: over each other, to first order, (n / n_here - 1) / slope.
void HollowProbe::light(const float* nearness, int width, float strength, float* light) const {
  std::fill_n(light, width, 0.0F);
  for (const Pair& pair : pairs_) {
    const float* const one = nearness + pair.offset;
    const float* const other = nearness - pair.offset;
    for (int k = 0; k < width; ++k) {
      const float here = nearness[k];
      const float per_length = parallel_ ? pair.per_unit : pair.per_unit / here;
      const float hollow = within_one((one[k] - here) * per_length) + within_one((other[k] - here) * per_length);
      light[k] += hollow > 0 ? hollow : 0;
    }
  }
  const float share = strength / (2 * static_cast<float>(pairs_.size()));
  const float nothing = parallel_ ? -std::numeric_limits<float>::infinity() : 0;
  for (int k = 0; k < width; ++k) light[k] = nearness[k] > nothing ? 1 - share * light[k] : 1;
}

}  // namespace packstone::viz
