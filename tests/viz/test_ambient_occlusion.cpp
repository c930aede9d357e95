// Shade in hollows: surfaces whose light is known.
#include <cmath>
#include <functional>
#include <limits>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "tests/viz/packings.hpp"
#include "viz/ambient_occlusion.hpp"
#include "viz/particle_scene.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

constexpr double reach = 5;  // [px]
constexpr float unit = 0.01F;

/// Light at the middle of a surface given as the distance at a place (x, y) [px] from the middle.
float light_of(const std::function<double(double, double)>& distance, bool parallel, float strength = 1) {
  const int margin = occlusion_margin(reach), side = 2 * margin + 1;
  std::vector<float> distances;
  for (int y = -margin; y <= margin; ++y) {
    for (int x = -margin; x <= margin; ++x) distances.push_back(static_cast<float>(distance(x, y)));
  }
  const HollowProbe probe(reach, unit, parallel, static_cast<std::size_t>(side));
  float light = -1;
  const std::vector<float> nearness = nearness_of(distances, parallel);
  probe.light(&nearness[static_cast<std::size_t>(margin * side + margin)], 1, strength, &light);
  return light;
}

constexpr double far_away = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("inclined planes lose no light") {
  for (const double slope : {0.0, 0.3, 0.6}) {
    // Distances of a plane across the line of sight, and of its picture in perspective.
    CHECK(light_of([&](double x, double y) { return 3 + slope * unit * (x + 0.5 * y); }, true) ==
          Approx(1).margin(1e-4));
    CHECK(light_of([&](double x, double y) { return 3 / (1 - slope * unit * (x - y)); }, false) ==
          Approx(1).margin(1e-4));
  }
}

TEST_CASE("the bottom of a narrow pit is dark by the strength, a bump and an edge keep their light") {
  const auto pit = [](double x, double y) { return std::hypot(x, y) < 1 ? 4.0 : 3.0; };
  for (const bool parallel : {true, false}) {
    CHECK(light_of(pit, parallel) == Approx(0).margin(1e-6));
    CHECK(light_of(pit, parallel, 0.4F) == Approx(0.6));
    CHECK(light_of([](double x, double y) { return 3 + 0.01 * std::hypot(x, y); }, parallel) == 1);
    CHECK(light_of([](double x, double) { return x > 0 ? far_away : 3; }, parallel) == 1);
    CHECK(light_of([](double, double) { return far_away; }, parallel) == 1);
  }
  // A groove with sides of 45 degrees along y: of the eight directions those across it see it full, the others less.
  double sum = 0;
  for (int k = 0; k < 8; ++k) sum += std::abs(std::cos(M_PI * k / 8)) / 8;
  CHECK(light_of([](double x, double) { return 3 - unit * std::abs(x); }, true) == Approx(1 - sum).margin(0.03));
}

TEST_CASE("hollows between particles are darker, single ones are not, and a wrong strength is refused") {
  PictureOptions options;
  options.width = 300;
  options.height = 200;
  options.legend = options.time = options.container = options.scale = options.axes = false;
  const auto sum = [&](const Snapshot& snapshot, double occlusion) {
    options.occlusion = occlusion;
    double total = 0;
    for (const std::uint8_t tone : draw_particles(snapshot, options).rgb) total += tone;
    return total;
  };
  const Snapshot single = testing::single_sphere(0.3), bed = testing::layered_packing(1);
  CHECK(sum(single, 1) > 0.999 * sum(single, 0));
  CHECK(sum(bed, 0.5) < 0.999 * sum(bed, 0));
  CHECK(sum(bed, 1) < sum(bed, 0.5));
  options.occlusion = 1.5;
  CHECK_THROWS_AS(ParticlePainter(options), InputError);
}
