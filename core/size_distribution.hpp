// Sizes of the particles of a group, drawn so that the group has the distribution that was asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace packstone {

enum class Distribution { uniform, normal, lognormal, weibull, list, table };
/// What the distribution counts: how many particles are of a size, or how much of the mass is.
enum class SharesBy { number, mass };

/// radius = { ... } of a group, where it is not one number. Which of the numbers it needs, its distribution says.
struct SizeSpec {
  bool present = false;
  Distribution distribution = Distribution::uniform;
  SharesBy by = SharesBy::number;
  std::optional<double> min, max;         ///< [m]; uniform; bounds of normal, lognormal, weibull
  std::optional<double> mean, deviation;  ///< normal [m]
  std::optional<double> median, spread;   ///< lognormal [m], geometric standard deviation
  std::optional<double> scale, shape;     ///< weibull [m]
  std::vector<double> radii;              ///< list: ascending; table: ends of its classes, ascending [m]
  std::vector<double> shares;             ///< of the list's sizes, or of the table's classes; any sum
};

/// What is wrong with it: the key below `radius` and the message; none if it is right.
struct SizeFault {
  std::string key, what;
};
std::optional<SizeFault> fault_of(const SizeSpec& spec);

/// Smallest and largest radius that can occur [m].
struct SizeRange {
  double smallest, largest;
};
SizeRange range_of(const SizeSpec& spec);

/// Radii of all `count` particles [m], in random order. Each stands for its own 1/count of the distribution, a list's
/// sizes occur as often as its shares say, rounded to whole particles: even a few particles have the sizes asked for.
/// stream_index: of the group, so that groups draw apart.
std::vector<double> drawn_radii(const SizeSpec& spec, std::int64_t count, std::uint64_t seed,
                                std::uint64_t stream_index);

}  // namespace packstone
