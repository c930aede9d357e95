#include <cstdlib>
#include <optional>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "tests/viz/packings.hpp"
#include "viz/offscreen.hpp"
#include "viz/particle_scene.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::EndsWith;

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

TEST_CASE("OSMesa, EGL and a window of VTK draw the same bytes, and say which of them it was") {
  PictureOptions options;
  options.width = 320;
  options.height = 240;
  Snapshot snapshot = testing::layered_packing(1);
  snapshot.boundaries.push_back(testing::upright_cylinder(0.5 * snapshot.domain.max, 0.4, 0.3, 24));
  const Image by_osmesa = draw_particles(snapshot, options);
  CHECK(renderer_in_use().rfind("OSMesa ", 0) == 0);
  use_backend(backend_named("egl"));
  const Image by_egl = draw_particles(snapshot, options);
  CHECK(renderer_in_use().rfind("EGL ", 0) == 0);
  use_backend(Backend::osmesa);
  CHECK((by_egl.rgb == by_osmesa.rgb));
  use_backend(backend_named("vtk"));
  std::optional<Image> by_vtk;
  try {
    by_vtk = draw_particles(snapshot, options);
  } catch (const RunError& error) {  // as VTK was built
    CHECK_THAT(error.what(), EndsWith("no off-screen window of its own; there are the backends osmesa and egl"));
  }
  if (by_vtk) {
    CHECK(renderer_in_use().rfind("VTK ", 0) == 0);
    CHECK((by_vtk->rgb == by_osmesa.rgb));
  }
  use_backend(Backend::osmesa);
  options.container = false;
  CHECK_FALSE((draw_particles(snapshot, options).rgb == by_osmesa.rgb));  // there were walls to compare
  CHECK_THROWS_AS(backend_named("glx"), InputError);
}
