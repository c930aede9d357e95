#include "core/size_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "core/random.hpp"

namespace packstone {

namespace {

constexpr double widest_deviations = 3;             ///< of normal and lognormal, unless bounds are given
constexpr double least_quantile = 0.001;            ///< of weibull, at either end
constexpr std::size_t grid_cells = 20000;           ///< of the tabulated cumulative distribution
constexpr std::uint64_t order_stream = 1ULL << 63;  ///< apart from the streams that draw sizes

std::optional<SizeFault> missing(const char* name,
                                 std::initializer_list<std::pair<const char*, const std::optional<double>*>> keys) {
  for (const auto& [key, value] : keys) {
    if (!*value) return SizeFault{"", fmt::format("needs {} for distribution = \"{}\"", key, name)};
  }
  return std::nullopt;
}

std::optional<SizeFault> fault_of_classes(const SizeSpec& s) {
  const bool table = s.distribution == Distribution::table;
  const std::size_t least = table ? 2 : 1;
  if (s.radii.size() < least) {
    return SizeFault{"radii", table ? "needs the ends of its classes, two at least" : "needs one radius at least"};
  }
  if (!std::is_sorted(s.radii.begin(), s.radii.end(), std::less_equal<>())) {
    return SizeFault{"radii", "must ascend, each larger than the one before"};
  }
  const std::size_t classes = table ? s.radii.size() - 1 : s.radii.size();
  if (!s.shares.empty() || table) {
    if (s.shares.size() != classes) {
      return SizeFault{"shares",
                       fmt::format("has {} entries; {} radii take {}", s.shares.size(), s.radii.size(), classes)};
    }
    if (std::accumulate(s.shares.begin(), s.shares.end(), 0.0) <= 0) return SizeFault{"shares", "are all 0"};
  }
  return std::nullopt;
}

/// Shares of a list's sizes by number, from those asked for.
std::vector<double> shares_of_number(const SizeSpec& s) {
  std::vector<double> shares = s.shares;
  if (shares.empty()) shares.assign(s.radii.size(), 1.0);
  if (s.by == SharesBy::mass) {
    for (std::size_t k = 0; k < shares.size(); ++k) shares[k] /= s.radii[k] * s.radii[k] * s.radii[k];
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share /= sum;
  return shares;
}

/// Whole particles of each size that are nearest to the shares (largest remainders).
std::vector<double> listed_radii(const SizeSpec& s, std::int64_t count) {
  const std::vector<double> shares = shares_of_number(s);
  std::vector<std::int64_t> counts;
  std::vector<std::pair<double, std::size_t>> remainders;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    const double exact = shares[k] * static_cast<double>(count);
    counts.push_back(static_cast<std::int64_t>(exact));
    remainders.emplace_back(static_cast<double>(counts.back()) - exact, k);  // most negative first
  }
  std::sort(remainders.begin(), remainders.end());
  const std::int64_t given = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  for (std::int64_t k = 0; k < count - given; ++k)
    ++counts[remainders[static_cast<std::size_t>(k) % counts.size()].second];
  std::vector<double> radii;
  for (std::size_t k = 0; k < counts.size(); ++k)
    radii.insert(radii.end(), static_cast<std::size_t>(counts[k]), s.radii[k]);
  return radii;
}

/// Density of the distribution as it is asked for, up to a factor.
double density(const SizeSpec& s, double r) {
  switch (s.distribution) {
    case Distribution::normal: {
      const double x = (r - *s.mean) / *s.deviation;
      return std::exp(-0.5 * x * x);
    }
    case Distribution::lognormal: {
      const double x = std::log(r / *s.median) / std::log(*s.spread);
      return std::exp(-0.5 * x * x) / r;
    }
    case Distribution::weibull:
      return std::pow(r / *s.scale, *s.shape - 1) * std::exp(-std::pow(r / *s.scale, *s.shape));
    case Distribution::table: {
      const auto above = std::upper_bound(s.radii.begin(), s.radii.end() - 1, r);
      const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - s.radii.begin() - 1, 0));
      return s.shares[std::min(k, s.shares.size() - 1)] / (s.radii[k + 1] - s.radii[k]);
    }
    case Distribution::uniform:
    case Distribution::list:
      break;
  }
  return 1;
}

/// Radius at quantiles of the number distribution, by its cumulative sum on a fine grid.
class Quantiles {
 public:
  explicit Quantiles(const SizeSpec& spec) : range_(range_of(spec)), cumulative_(grid_cells + 1, 0.0) {
    for (std::size_t k = 0; k < grid_cells; ++k) {
      const double r = radius_at(static_cast<double>(k) + 0.5);
      const double by_number = spec.by == SharesBy::mass ? 1 / (r * r * r) : 1;
      cumulative_[k + 1] = cumulative_[k] + density(spec, r) * by_number;
    }
  }

  double operator()(double quantile) const {
    const double wanted = quantile * cumulative_.back();
    const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end(), wanted);
    const auto k = std::min<std::size_t>(std::max<std::ptrdiff_t>(above - cumulative_.begin() - 1, 0), grid_cells - 1);
    const double width = cumulative_[k + 1] - cumulative_[k];
    return radius_at(static_cast<double>(k) + (width > 0 ? (wanted - cumulative_[k]) / width : 0.0));
  }

 private:
  double radius_at(double cell) const {
    return range_.smallest + (range_.largest - range_.smallest) * cell / static_cast<double>(grid_cells);
  }

  SizeRange range_;
  std::vector<double> cumulative_;
};

}  // namespace

std::optional<SizeFault> fault_of(const SizeSpec& s) {
  std::optional<SizeFault> fault;
  switch (s.distribution) {
    case Distribution::uniform:
      fault = missing("uniform", {{"min", &s.min}, {"max", &s.max}});
      break;
    case Distribution::normal:
      fault = missing("normal", {{"mean", &s.mean}, {"deviation", &s.deviation}});
      break;
    case Distribution::lognormal:
      fault = missing("lognormal", {{"median", &s.median}, {"spread", &s.spread}});
      break;
    case Distribution::weibull:
      fault = missing("weibull", {{"scale", &s.scale}, {"shape", &s.shape}});
      break;
    case Distribution::list:
    case Distribution::table:
      return fault_of_classes(s);
  }
  if (fault) return fault;
  const SizeRange range = range_of(s);
  if (!(range.smallest > 0)) {
    return SizeFault{"min", fmt::format("the distribution reaches down to {:g} m; give a min above 0", range.smallest)};
  }
  if (!(range.largest > range.smallest)) {
    return SizeFault{
        "max", fmt::format("{:g} m does not lie above the smallest radius, {:g} m", range.largest, range.smallest)};
  }
  return std::nullopt;
}

SizeRange range_of(const SizeSpec& s) {
  SizeRange range{0, 0};
  switch (s.distribution) {
    case Distribution::normal:
      range = {*s.mean - widest_deviations * *s.deviation, *s.mean + widest_deviations * *s.deviation};
      break;
    case Distribution::lognormal: {
      const double factor = std::pow(*s.spread, widest_deviations);
      range = {*s.median / factor, *s.median * factor};
      break;
    }
    case Distribution::weibull: {
      const auto at = [&](double quantile) { return *s.scale * std::pow(-std::log1p(-quantile), 1 / *s.shape); };
      range = {at(least_quantile), at(1 - least_quantile)};
      break;
    }
    case Distribution::list:
    case Distribution::table:
      return {s.radii.front(), s.radii.back()};
    case Distribution::uniform:
      break;
  }
  return {s.min.value_or(range.smallest), s.max.value_or(range.largest)};
}

std::vector<double> drawn_radii(const SizeSpec& spec, std::int64_t count, std::uint64_t seed,
                                std::uint64_t stream_index) {
  std::vector<double> radii;
  if (spec.distribution == Distribution::list) {
    radii = listed_radii(spec, count);
  } else {
    const Quantiles quantiles(spec);
    Random random(seed, RandomStream::particle_radius, stream_index);
    for (std::int64_t k = 0; k < count; ++k) {
      radii.push_back(quantiles((static_cast<double>(k) + random.uniform()) / static_cast<double>(count)));
    }
  }
  Random order(seed, RandomStream::particle_radius, order_stream | stream_index);
  shuffle(radii, order);
  return radii;
}

}  // namespace packstone
