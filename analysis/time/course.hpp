// Measure "course": what happens between the snapshots of a series.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/context.hpp"
#include "analysis/result.hpp"
#include "core/history.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

inline const std::string course_name = "course";
inline const std::string course_description =
    "over a series: mean squared displacement, trajectories, decay of the energy (with --at all)";

/// Takes the snapshots of a series one by one, in order, and keeps of each what the course needs.
class Course {
 public:
  /// trajectories: ids of particles to follow.
  explicit Course(std::vector<std::int64_t> trajectories) : followed_(std::move(trajectories)) {}

  /// Throws InputError when a snapshot lacks a particle that is to be followed, or comes before the last in time.
  void add(const Snapshot& snapshot);

  /// history: of the run, null without.
  MeasureResult result(const History* history) const;

 private:
  struct Walker {
    std::int64_t id;
    Vec3 position;      ///< in the last snapshot [m]
    Vec3 displacement;  ///< since the first snapshot [m]
    std::int32_t type;
  };
  struct Moved {
    double time;
    std::int32_t type;  ///< -1: all
    double particles;
    Vec3 mean;     ///< displacement [m]
    Vec3 squared;  ///< mean of the squares about that mean [m2]
  };

  void follow(const Snapshot& snapshot);
  void summarise(double time);
  void record_trajectories(double time);
  Table displacement_table() const;
  Table trajectory_table() const;

  std::vector<std::int64_t> followed_;
  std::vector<Walker> walkers_;  ///< those in every snapshot so far, by ascending id
  std::vector<Moved> moved_;
  std::vector<std::vector<double>> trajectory_;  ///< rows of the table
  std::vector<std::string> group_names_;
  double last_time_ = 0;
  double largest_jump_ = 0;  ///< over half of the period, between two snapshots
  double weight_ = 0;        ///< sum of m g d in the last snapshot [J]
  std::size_t snapshots_ = 0;
};

}  // namespace packstone::analysis
