#include "core/bed.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry.hpp"

namespace packstone {

namespace {

constexpr double bracket_step = 1.2;
constexpr double largest_fraction = 2;      // with overlaps; bounds the search downwards
constexpr double height_tolerance = 1e-10;  // of the height
constexpr double volume_tolerance = 1e-13;  // of all solid; far smaller, as layers flatten the curve near its root
constexpr int most_iterations = 100;

struct Bed {
  std::span<const double> height;
  std::span<const double> radius;
  double volume = 0;
  double top = 0;
  double mass_height = 0;  // of the centre of mass

  /// Solid in the bulk of a bed of height h, above what a uniform bed would have there.
  double excess(double h) const {
    return solid_volume_between(height, radius, bulk_lower * h, bulk_upper * h) - (bulk_upper - bulk_lower) * volume;
  }
};

Bed summed(std::span<const double> height, std::span<const double> radius) {
  Bed bed{height, radius};
  double moment = 0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    const double v = sphere_volume(radius[i]);
    bed.volume += v;
    moment += v * height[i];
    bed.top = std::max(bed.top, height[i] + radius[i]);
  }
  if (bed.volume > 0) bed.mass_height = moment / bed.volume;
  return bed;
}

struct Bracket {
  double low, high;  // excess < 0 at low, >= 0 at high
};

/// From a height with excess, down to the first without.
Bracket bracket_below(const Bed& bed, double high) {
  double low = high / bracket_step;
  while (bed.excess(low) >= 0) low /= bracket_step;  // ends: the bulk of a bed of height 0 is empty
  return {low, low * bracket_step};
}

std::optional<Bracket> bracket_from(const Bed& bed, double start, double lowest) {
  if (bed.excess(start) >= 0) return bracket_below(bed, start);
  for (double high = start * bracket_step; bulk_lower * high < bed.top; high *= bracket_step) {
    if (bed.excess(high) >= 0) return Bracket{high / bracket_step, high};
  }
  for (double high = start / bracket_step; high > lowest; high /= bracket_step) {
    if (bed.excess(high) >= 0) return bracket_below(bed, high);
  }
  return std::nullopt;
}

/// Regula falsi, Illinois variant: never leaves the bracket.
double root_in(const Bed& bed, Bracket b) {
  double at_low = bed.excess(b.low), at_high = bed.excess(b.high);
  int side = 0;
  for (int k = 0; k < most_iterations && b.high - b.low > height_tolerance * b.high && at_high > 0; ++k) {
    const double h = std::clamp((b.low * at_high - b.high * at_low) / (at_high - at_low), b.low, b.high);
    const double value = bed.excess(h);
    if (std::abs(value) <= volume_tolerance * bed.volume) return h;
    if (value < 0) {
      b.low = h;
      at_low = value;
      if (side == -1) at_high /= 2;
      side = -1;
    } else {
      b.high = h;
      at_high = value;
      if (side == +1) at_low /= 2;
      side = +1;
    }
  }
  return b.high;
}

}  // namespace

double solid_volume_between(std::span<const double> height, std::span<const double> radius, double lower,
                            double upper) {
  double volume = 0;
  for (std::size_t i = 0; i < height.size(); ++i) volume += sphere_slab_volume(radius[i], height[i], lower, upper);
  return volume;
}

BedState measure_bed(std::span<const double> height_above_floor, std::span<const double> radius, double area) {
  const Bed bed = summed(height_above_floor, radius);
  if (!(area > 0) || !(bed.volume > 0) || !(bed.top > 0)) return {};
  const double guess = bed.mass_height > 0 ? 2 * bed.mass_height : bed.top;
  const auto bracket = bracket_from(bed, guess, bed.volume / (area * largest_fraction));
  const double height = bracket ? root_in(bed, *bracket) : guess;
  return {bed.volume / (height * area), height};
}

}  // namespace packstone
