// What is read for a picture with a part cut away: fewer chunks, the same bytes.
#include <random>

#include <catch2/catch.hpp>

#include "tests/temporary_folder.hpp"
#include "tests/viz/packings.hpp"
#include "viz/particle_scene.hpp"

using namespace packstone;
using namespace packstone::viz;

TEST_CASE("a box is cut away where all of its points are") {
  const CutAway corner = cut_from_text("x>0.3,y<0.2");
  const auto box = [](double x, double y) { return Region{{x, y, 0}, {x + 0.1, y + 0.1, 1}}; };
  CHECK(is_cut_away(corner, box(0.35, 0.05)));
  CHECK_FALSE(is_cut_away(corner, box(0.25, 0.05)));
  CHECK_FALSE(is_cut_away(corner, box(0.35, 0.15)));
  CHECK_FALSE(is_cut_away(corner, box(0.1, 0.5)));
  CHECK_FALSE(is_cut_away({}, box(0.35, 0.05)));
}

TEST_CASE("without the chunks that are cut away, and without columns it does not show, a picture is the same") {
  const testing::TemporaryFolder folder;
  Snapshot packing = testing::empty_box(Vec3::Ones());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  for (int k = 0; k < 60000; ++k) {
    testing::add_particle(packing, {place(random), place(random), place(random)}, 0.007, k % 2);
  }
  write_snapshot(folder / "a.vtkhdf", packing);
  PictureOptions options;
  options.width = 160;
  options.height = 120;
  options.occlusion = 1;
  for (const char* cut : {"x>0.4", "x>0.3,y<0.7", "z>-1"}) {
    INFO(cut);
    options.cut = cut_from_text(cut);
    const Snapshot whole = read_snapshot(folder / "a.vtkhdf");
    const Snapshot part = read_snapshot(
        folder / "a.vtkhdf", {.region = {},
                              .contacts = false,
                              .fields = false,
                              .ids = false,
                              .materials = false,
                              .wants_chunk = [&](const Region& box) { return !is_cut_away(options.cut, box); }});
    CHECK(part.size() < whole.size());
    CHECK(part.id.empty());
    CHECK(part.material.empty());
    CHECK(part.type.size() == part.size());
    CHECK((draw_particles(part, options).rgb == draw_particles(whole, options).rgb));
  }
}
