// Motion of layers, displacement over a series, decay of energy.
#include <cmath>

#include <catch2/catch.hpp>
#include <omp.h>

#include "analysis/series.hpp"
#include "analysis/time/course.hpp"
#include "analysis/time/rest.hpp"
#include "core/error.hpp"
#include "core/formats/packing_output.hpp"
#include "core/run_folder.hpp"
#include "tests/analysis/fixtures.hpp"
#include "tests/temporary_folder.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;
using Catch::Matchers::Contains;

namespace {

/// Evenly spread within +-sqrt(3), so of variance 1.
double of_unit_variance(Random& random) { return std::sqrt(3.0) * random.uniform(-1, 1); }

void set_velocities(Snapshot& s, const std::function<Vec3(std::size_t)>& velocity) {
  Field& field = s.fields["velocity"];
  field = {3, "m/s", {}};
  for (std::size_t i = 0; i < s.size(); ++i) {
    for (const double v : velocity(i)) field.values.push_back(v);
  }
}

History falling_energy(double decay_time, double first, double after) {
  History history;
  history.columns = {"time", "kinetic_translational", "kinetic_rotational"};
  history.values.resize(3);
  for (int k = 0; k <= 2000; ++k) {
    const double time = first + after * k / 2000;
    const double energy = time < first + decay_time ? time : std::exp(-(time - first) / decay_time);
    history.values[0].push_back(time);
    history.values[1].push_back(0.75 * energy);
    history.values[2].push_back(0.25 * energy);
  }
  return history;
}

}  // namespace

TEST_CASE("granular temperature is the variance of a velocity component about the layer's flow") {
  Snapshot s = cubic_bed(10, 10, 10);
  Random random(3, RandomStream::filling_position, 0);
  constexpr double sigma = 0.2;
  set_velocities(s, [&](std::size_t i) {
    const Vec3 noise(of_unit_variance(random), of_unit_variance(random), of_unit_variance(random));
    return Vec3(sigma * noise + Vec3(s.position[i].z(), 1, -2));  // each layer flows on its own
  });
  const auto result = measured(s, "time");
  const Quantity& temperature = *result.quantity("granular_temperature");
  CHECK(*temperature.uncertainty == Approx(*temperature.value * std::sqrt(2.0 / (3 * 990))));
  CHECK(std::abs(*temperature.value - sigma * sigma) < 4 * *temperature.uncertainty);
  const auto& rows = result.table("layers")->rows;
  REQUIRE(rows.size() == 10);
  CHECK(rows[2][2] == 100);
  CHECK(rows[2][3] == Approx(5).margin(4 * sigma / 10));
  CHECK(rows[2][5] == Approx(-2).margin(4 * sigma / 10));
}

TEST_CASE("the temperature of two particles is half their relative velocity squared, over three") {
  Snapshot s = empty_box(Vec3(10, 10, 10));
  for (const double x : {2.0, 8.0}) add_particle(s, Vec3(x, 5, 1), 1);
  set_velocities(s, [](std::size_t i) { return Vec3(i == 0 ? 4 : 1, 7, 0); });
  // Equal masses: sum m |v - V|^2 = m 9/2; sum m - sum m^2 / M = m.
  CHECK(value(measured(s, "time"), "granular_temperature") == Approx(4.5 / 3));
}

TEST_CASE("the bed rests up to the lowest layer that moves") {
  Snapshot s = cubic_bed(5, 5, 6);
  const double slow = std::sqrt(2 * 0.9 * rest_threshold * 9.8 * 2),
               fast = std::sqrt(2 * 1.1 * rest_threshold * 9.8 * 2);
  set_velocities(s, [&](std::size_t i) { return Vec3(0, 0, s.position[i].z() > 6 ? -fast : -slow); });
  CHECK(value(measured(s, "time"), "rest_height") == Approx(6).epsilon(1e-6));
  set_velocities(s, [&](std::size_t) { return Vec3(0, 0, -slow); });
  CHECK(value(measured(s, "time"), "rest_height") == Approx(value(measured(s, "packing"), "bed_height")));
  s.gravity.setZero();
  CHECK_FALSE(measured(s, "time").quantity("rest_height")->value);
  s.fields.clear();
  CHECK_FALSE(measured(s, "time").quantity("granular_temperature")->value);
}

TEST_CASE("displacements go the shortest way over periodic sides and count about their mean") {
  // Particles go by 3 in x, in a box of 10, a step: three times round. Half of them go up by 1, half down.
  Snapshot s = empty_box(Vec3(10, 10, 10), {true, true, false});
  for (int k = 0; k < 8; ++k) add_particle(s, Vec3(1 + k, 5, 5), 0.5, k % 2);
  Course course({s.id[3]});
  for (int step = 0; step <= 10; ++step) {
    s.time = 0.1 * step;
    course.add(s);
    std::reverse(s.id.begin(), s.id.end());  // rows change places from snapshot to snapshot
    std::reverse(s.position.begin(), s.position.end());
    std::reverse(s.type.begin(), s.type.end());
    for (std::size_t i = 0; i < s.size(); ++i) {
      s.position[i] = s.domain.wrapped(s.position[i] + Vec3(3, 0, s.type[i] == 0 ? 0.1 : -0.1));
    }
  }
  const MeasureResult result = course.result(nullptr);
  CHECK(value(result, "msd") == Approx(1));
  CHECK_THAT(result.quantity("msd")->note, Contains("60 % of half a period"));
  const auto& last = result.table("displacement")->rows.back();
  CHECK(last[1] == 1);
  CHECK(last[2] == 4);
  CHECK(last[3] == Approx(30));
  CHECK(last[5] == Approx(-1));
  CHECK(last[9] == Approx(0).margin(1e-12));  // all of type 1 went alike
  const auto& way = result.table("trajectories")->rows.back();
  CHECK(way[1] == 1021);
  CHECK(way[2] == Approx(4).margin(1e-9));
  CHECK(way[5] == Approx(30));
  CHECK_FALSE(result.quantity("kinetic_peak")->value);
}

TEST_CASE("particles of another program's dumps are followed by id, though their rows change with their places") {
  const testing::TemporaryFolder folder;
  Snapshot s = empty_box(Vec3(10, 10, 10), {true, true, false});
  for (int k = 0; k < 8; ++k) add_particle(s, Vec3(1 + k, 5, 1 + k), 0.5);
  PackingWriter writer(folder / "a.dump");
  writer.write(s);
  for (Vec3& p : s.position) p = Vec3(p.x() - 2, p.y(), 10 - p.z());  // the lowest comes to lie highest
  s.time = 1;
  for (Vec3& p : s.position) p = s.domain.wrapped(p);
  writer.write(s);
  writer.finish();
  const RunReader run(folder / "a.dump");
  CHECK(run.snapshot(0).id != run.snapshot(1).id);
  SeriesOptions options;
  options.only = {course_name};
  options.trajectories = {1000, 1049};
  const std::vector<std::size_t> both = {0, 1};
  const MeasureResult course = analyze_series(run, both, options).back().results.back();
  const auto& rows = course.table("trajectories")->rows;
  REQUIRE(rows.size() == 4);
  for (const auto& row : rows) {
    if (row[0] == 0) continue;
    CHECK(row[5] == Approx(-2));
    CHECK(row[7] == Approx(row[1] == 1000 ? 8 : -6));  // from z = 1 to 9, from 8 to 2
  }
}

TEST_CASE("particles that come later do not count, those that are gone end it") {
  Snapshot s = empty_box(Vec3(10, 10, 10));
  Course course({});
  course.add(s);
  CHECK_FALSE(course.result(nullptr).quantity("msd")->value);
  add_particle(s, Vec3(1, 1, 1), 0.5);
  course.add(s);
  CHECK_FALSE(course.result(nullptr).quantity("msd")->value);
  s.time = -1;
  CHECK_THROWS_AS(course.add(s), InputError);
  Course follows({4711});
  CHECK_THROWS_WITH(follows.add(s), Contains("4711"));
}

TEST_CASE("energy decay: an exponential's own time, and when it is at rest") {
  Snapshot s = empty_box(Vec3(10, 10, 10));
  add_particle(s, Vec3(1, 1, 1), 0.05);
  Course course({});
  course.add(s);
  constexpr double tau = 0.25;
  const History history = falling_energy(tau, 0.1, 50);
  const MeasureResult result = course.result(&history);
  // It rises to 0.35 at 0.35, then follows exp(-(t - 0.1)/tau), which begins at 1/e.
  constexpr double row = 50.0 / 2000;
  CHECK(value(result, "kinetic_peak") == Approx(std::exp(-1)));
  CHECK(value(result, "kinetic_decay_time") == Approx(tau).margin(1.01 * row));
  const double weight = s.mass(0) * 9.8 * 0.1;
  const double late = value(result, "time_to_rest") - (0.1 - tau * std::log(rest_threshold * weight));
  CHECK((late >= 0 && late <= 1.01 * row));
  const History shorter = falling_energy(tau, 0.1, 0.2);
  CHECK_FALSE(course.result(&shorter).quantity("time_to_rest")->value);
  CHECK_FALSE(course.result(&shorter).quantity("kinetic_decay_time")->value);
}

TEST_CASE("a series gives the same numbers for any number of threads, and its course at the end") {
  const packstone::testing::TemporaryFolder folder;
  RunWriter writer(folder / "run", false);
  writer.write_record({});
  writer.write_scene("");
  writer.append_history({"time", "kinetic_translational", "kinetic_rotational"}, {0, 1, 0});
  Snapshot s = cubic_bed(5, 5, 5);
  for (int k = 0; k < 5; ++k) {
    s.time = k;
    label_at_random(s, static_cast<std::uint64_t>(k));
    writer.write_snapshot(s);
  }
  const RunReader run(folder / "run");
  const std::vector<std::size_t> all = {0, 1, 2, 3, 4};
  const int threads = omp_get_max_threads();
  std::size_t calls = 0;
  SeriesOptions options;
  options.progress = [&](std::size_t) { ++calls; };
  omp_set_num_threads(1);
  const auto alone = analyze_series(run, all, options);
  omp_set_num_threads(3);
  const auto together = analyze_series(run, all, options);
  omp_set_num_threads(threads);
  CHECK(calls == 10);
  REQUIRE(alone.size() == 5);
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK(together[k].time == static_cast<double>(k));
    REQUIRE(alone[k].results.size() == together[k].results.size());
    for (std::size_t m = 0; m < alone[k].results.size(); ++m) {
      const auto& one = alone[k].results[m].quantities;
      const auto& other = together[k].results[m].quantities;
      REQUIRE(one.size() == other.size());
      for (std::size_t q = 0; q < one.size(); ++q) CHECK(one[q].value == other[q].value);
    }
  }
  CHECK(alone[3].results.back().name != "course");
  CHECK(alone[4].results.back().name == "course");
  CHECK(value(alone[4].results.back(), "msd") == 0);

  options.only = {"course"};
  CHECK(analyze_series(run, all, options).back().results.size() == 1);
  CHECK_THROWS_AS(analyze_series(run, std::span(all).first(1), options), InputError);
  options.only = {"packing"};
  options.trajectories = {1000};
  CHECK_THROWS_AS(analyze_series(run, all, options), InputError);
  options.only = {"packings"};
  options.trajectories.clear();
  CHECK_THROWS_WITH(analyze_series(run, all, options), Contains("packing"));
}
