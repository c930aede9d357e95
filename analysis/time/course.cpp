#include "analysis/time/course.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "analysis/time/energy_decay.hpp"
#include "core/error.hpp"

namespace packstone::analysis {

namespace {

constexpr std::int32_t all_types = -1;
constexpr double safe_jump = 0.5;  ///< of half a period: beyond, the image a particle came from is a guess

}  // namespace

void Course::follow(const Snapshot& snapshot) {
  const std::vector<std::size_t> rows = id_order(snapshot);
  if (snapshots_ == 0) {
    for (const GroupRecord& group : snapshot.groups) group_names_.push_back(group.name);
    for (const std::size_t i : rows) {
      walkers_.push_back({snapshot.id[i], snapshot.position[i], Vec3::Zero(), snapshot.type[i]});
    }
    return;
  }
  const Vec3 period = snapshot.domain.size();
  std::size_t kept = 0;
  auto row = rows.begin();
  for (Walker walker : walkers_) {
    while (row != rows.end() && snapshot.id[*row] < walker.id) ++row;
    if (row == rows.end() || snapshot.id[*row] != walker.id) continue;
    const Vec3 step = snapshot.domain.separation(snapshot.position[*row], walker.position);
    for (int k = 0; k < 3; ++k) {
      if (snapshot.domain.periodic[k]) largest_jump_ = std::max(largest_jump_, 2 * std::abs(step[k]) / period[k]);
    }
    walker.displacement += step;
    walker.position = snapshot.position[*row];
    walkers_[kept++] = walker;
  }
  walkers_.resize(kept);
}

void Course::summarise(double time) {
  struct Sum {
    double particles = 0;
    Vec3 first = Vec3::Zero(), second = Vec3::Zero();
  };
  std::map<std::int32_t, Sum> sums;
  for (const Walker& walker : walkers_) {
    for (const std::int32_t type : {all_types, walker.type}) {
      Sum& sum = sums[type];
      ++sum.particles;
      sum.first += walker.displacement;
      sum.second += walker.displacement.cwiseAbs2();
    }
  }
  for (const auto& [type, sum] : sums) {
    const Vec3 mean = sum.first / sum.particles;
    moved_.push_back(
        {time, type, sum.particles, mean, (sum.second / sum.particles - mean.cwiseAbs2()).cwiseMax(Vec3::Zero())});
  }
}

void Course::add(const Snapshot& snapshot) {
  if (snapshots_ > 0 && snapshot.time < last_time_) {
    throw InputError(fmt::format("the snapshot at {:g} s comes after that at {:g} s; a course runs forward in time",
                                 snapshot.time, last_time_));
  }
  follow(snapshot);
  ++snapshots_;
  last_time_ = snapshot.time;
  summarise(snapshot.time);
  record_trajectories(snapshot.time);
  weight_ = 0;
  for (std::size_t i = 0; i < snapshot.size() && snapshot.has_masses(); ++i) {
    weight_ += snapshot.mass(i) * snapshot.gravity.norm() * 2 * snapshot.radius[i];
  }
}

void Course::record_trajectories(double time) {
  for (const std::int64_t id : followed_) {
    const auto walker = std::lower_bound(walkers_.begin(), walkers_.end(), id,
                                         [](const Walker& w, std::int64_t wanted) { return w.id < wanted; });
    if (walker == walkers_.end() || walker->id != id) {
      throw InputError(fmt::format("particle {} is not in all snapshots up to {:g} s", id, time));
    }
    const Vec3 &x = walker->position, &d = walker->displacement;
    trajectory_.push_back({time, static_cast<double>(id), x[0], x[1], x[2], d[0], d[1], d[2]});
  }
}

Table Course::displacement_table() const {
  std::string legend;
  for (std::size_t k = 0; k < group_names_.size(); ++k) legend += fmt::format(", {} {}", k, group_names_[k]);
  Table table{
      .key = "displacement",
      .caption = "Displacement since the first snapshot, of the particles in all snapshots so far, by type (-1 all" +
                 legend +
                 "): mean, and mean square about that mean, by axis and in all; over periodic sides the shortest "
                 "way from snapshot to snapshot",
      .columns = {{"time", "s"},
                  {"type", "", ColumnFormat::integer},
                  {"particles", "", ColumnFormat::integer},
                  {"mean_x", "m"},
                  {"mean_y", "m"},
                  {"mean_z", "m"},
                  {"msd_x", "m2"},
                  {"msd_y", "m2"},
                  {"msd_z", "m2"},
                  {"msd", "m2"}}};
  for (const Moved& m : moved_) {
    table.rows.push_back({m.time, static_cast<double>(m.type), m.particles, m.mean[0], m.mean[1], m.mean[2],
                          m.squared[0], m.squared[1], m.squared[2], m.squared.sum()});
  }
  return table;
}

Table Course::trajectory_table() const {
  return {.key = "trajectories",
          .caption =
              "Positions of the chosen particles, and displacement since the first snapshot with periodic sides "
              "undone",
          .columns = {{"time", "s"},
                      {"id", "", ColumnFormat::integer},
                      {"x", "m"},
                      {"y", "m"},
                      {"z", "m"},
                      {"displacement_x", "m"},
                      {"displacement_y", "m"},
                      {"displacement_z", "m"}},
          .rows = trajectory_};
}

MeasureResult Course::result(const History* history) const {
  MeasureResult result{.name = course_name};
  Quantity msd{.key = "msd",
               .label = "mean squared displacement",
               .unit = "m2",
               .definition =
                   "mean of |x - x_first - mean displacement|^2 over the particles in all snapshots, from the "
                   "first to the last snapshot measured; over periodic sides the shortest way from snapshot to "
                   "snapshot"};
  if (snapshots_ < 2 || walkers_.empty()) {
    msd = not_applicable(msd, snapshots_ < 2 ? "one snapshot only" : "no particle is in all snapshots");
  } else {
    const auto last = std::find_if(moved_.rbegin(), moved_.rend(), [](const Moved& m) { return m.type == all_types; });
    msd.value = last->squared.sum();
    if (largest_jump_ > safe_jump) {
      msd.note = fmt::format(
          "a particle went {:.0f} % of half a period between two snapshots: some may have gone the "
          "other way round; write snapshots more often",
          100 * largest_jump_);
    }
  }
  result.quantities.push_back(msd);
  add_energy_decay(result, history, weight_);
  result.tables.push_back(displacement_table());
  if (!followed_.empty()) result.tables.push_back(trajectory_table());
  return result;
}

}  // namespace packstone::analysis
