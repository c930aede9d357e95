#include <cstdlib>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "tests/viz/packings.hpp"
#include "viz/offscreen.hpp"
#include "viz/particle_scene.hpp"

using namespace packstone;
using namespace packstone::viz;

TEST_CASE("a picture needs no display") {
  PictureOptions options;
  options.width = 80;
  options.height = 60;
  const Snapshot snapshot = testing::layered_packing(1);
  unsetenv("DISPLAY");
  const Image without = draw_particles(snapshot, options);
  setenv("DISPLAY", "no-such-host:99.7", 1);
  const Image with_nonsense = draw_particles(snapshot, options);
  unsetenv("DISPLAY");
  CHECK(without.rgb == with_nonsense.rgb);
}

TEST_CASE("a size the software renderer cannot draw is refused") {
  CHECK_THROWS_AS(OffscreenWindow(max_side + 1, 10), InputError);
  CHECK_THROWS_AS(OffscreenWindow(10, 0), InputError);
  PictureOptions options;
  options.width = 32769;
  CHECK_THROWS_AS(ParticlePainter(options), InputError);
}
