// How wide the margins of a neighbour list should be, and when a calmer bed deserves a narrower list.
#pragma once

#include <cstdint>
#include <optional>

#include "core/archive.hpp"

namespace packstone::engine {

/// The margin of particle i is size_share R_i + 1.25 life |v_i - u| [m], u the particles' mean velocity: what it may
/// move, by pushes from others and by its own motion, before the list is built anew. The quarter more keeps the fastest
/// from ending every list and passing for agitation of all.
struct Margins {
  double size_share = 0;
  double life = 0;  ///< that the list is meant to have [s]

  static constexpr double flight_allowance = 1.25;

  void archive(Archive& a) { a(size_share, life); }
};

/// Weighs the length of the list, which every step pays for, against the work of building it. Decides from what the
/// particles did, never from a clock, so that a run repeats.
class MarginPolicy {
 public:
  /// size_share: of all lists; none: weighed anew for each.
  explicit MarginPolicy(std::optional<double> size_share) : fixed_(size_share) {}

  /// Margins of the next list. mean_speed: of |v_i - u|/R_i [1/s].
  Margins next(double dt, double mean_speed);

  /// Learns from a list that has served some steps; used: the largest share of a margin that a particle has used up.
  void learn(double used, std::int64_t steps, double dt);

  /// Whether a narrower list would pay within as many steps again as the present one has served. Looks at a few ages
  /// only.
  bool worth_renewing(double used, std::int64_t steps, double dt) const;

  void archive(Archive& a) { a(margins_, agitation_, mean_speed_); }

 private:
  Margins balanced(double agitation, double dt, double mean_speed) const;

  std::optional<double> fixed_;
  Margins margins_;
  double agitation_ =
      -1;  ///< largest part of its radius that a particle moves in a second, by pushes; negative: unknown
  double mean_speed_ = 0;
};

}  // namespace packstone::engine
