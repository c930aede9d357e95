// Particles that come in over time.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "core/archive.hpp"
#include "core/bed_frame.hpp"
#include "core/scene.hpp"
#include "engine/boundary/boundaries.hpp"
#include "engine/dynamics/particles.hpp"
#include "engine/filling/starting_state.hpp"

namespace packstone::engine {

class Pouring {
 public:
  /// Throws InputError when the run is too short for the rate.
  explicit Pouring(const Scene& scene);

  /// All that are to be poured, in the order in which they come: groups mixed at random by the seed. Without places.
  const StartingState& all() const { return all_; }
  double total_mass() const { return std::accumulate(mass_.begin(), mass_.end(), 0.0); }  ///< of all [kg]
  bool over() const { return over_ || poured_ == all_.size(); }
  std::size_t poured() const { return poured_; }

  /// Those that are in, by id, at an instant.
  struct Bed {
    const BedFrame& frame;
    const std::vector<double>& radius;  ///< [m]
    const std::vector<Vec3>& velocity;  ///< [m/s]
    const std::vector<Vec3>& force;     ///< contacts and gravity [N]
    Vec3 gravity;                       ///< [m/s2]
  };
  /// unrest: root-mean-square speed [m/s], of overdamped motion unbalanced force.
  void see(const Bed& bed, double unrest);

  /// Those that come in now, as many as are due and find room at random places of the region; none at most steps.
  StartingState take(double time, double dt, const Particles& particles, const Boundaries& boundaries);

  /// How far it has come.
  void archive(Archive& a) { a(poured_mass_, poured_, portion_end_, draws_, next_time_, over_); }

 private:
  std::size_t due(double time) const;
  void begin_portion();
  double settled_height(const Bed& bed) const;

  Scene scene_;
  Domain domain_;
  StartingState all_;
  std::vector<double> mass_;  ///< [kg]
  double poured_mass_ = 0;    ///< [kg]
  std::size_t poured_ = 0;
  std::size_t portion_end_ = 0;  ///< of all those in the portions begun
  std::uint64_t draws_ = 0;      ///< of places so far
  double next_time_ = 0;         ///< to look again [s]
  bool over_ = false;
};

}  // namespace packstone::engine
