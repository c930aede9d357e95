// What is looked at of a file for a picture: chunks that are seen, and the same bytes as of the whole in memory.
#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/open_snapshot.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/viz/bare_picture.hpp"
#include "tests/viz/packings.hpp"
#include "viz/particle_scene.hpp"
#include "viz/slice.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

Snapshot crowd(int count, double radius = 0.007) {
  Snapshot packing = testing::empty_box(Vec3::Ones());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  Field heat{1, "J", {}};
  for (int k = 0; k < count; ++k) {
    testing::add_particle(packing, {place(random), place(random), place(random)}, radius, k % 2);
    heat.values.push_back(place(random));
  }
  packing.fields["heat"] = heat;
  return packing;
}

}  // namespace

TEST_CASE("a box is cut away where all of its points are") {
  const CutAway corner = cut_from_text("x>0.3,y<0.2");
  const auto box = [](double x, double y) { return Region{{x, y, 0}, {x + 0.1, y + 0.1, 1}}; };
  CHECK(is_cut_away(corner, box(0.35, 0.05)));
  CHECK_FALSE(is_cut_away(corner, box(0.25, 0.05)));
  CHECK_FALSE(is_cut_away(corner, box(0.35, 0.15)));
  CHECK_FALSE(is_cut_away(corner, box(0.1, 0.5)));
  CHECK_FALSE(is_cut_away({}, box(0.35, 0.05)));
}

TEST_CASE("particles looked at in their file make the picture that they make in memory") {
  const testing::TemporaryFolder folder;
  write_snapshot(folder / "a.vtkhdf", crowd(60'000));
  const Snapshot whole = read_snapshot(folder / "a.vtkhdf");
  const OpenSnapshot open(folder / "a.vtkhdf");
  PictureOptions options;
  options.width = 160;
  options.height = 120;
  const auto same = [&] { return draw_particles(open.view(), options).rgb == draw_particles(whole, options).rgb; };
  for (const double occlusion : {0.0, 1.0}) {
    options.occlusion = occlusion;
    for (const char* cut : {"", "x>0.4", "x>0.3,y<0.7", "z>-1"}) {
      INFO(cut);
      options.cut = cut_from_text(cut);
      CHECK(same());
    }
  }
  for (const char* color : {"heat", "radius", "material"}) {
    options.color = color;
    CHECK(same());
  }
  options.parts = 8;
  options.view.zoom = 4;
  CHECK(same());
  options.shown = Shown::shrunk;
  CHECK(same());
}

TEST_CASE("of chunks that are not seen no row is looked at") {
  const testing::TemporaryFolder folder;
  Snapshot packing = crowd(60'000);
  packing.boundaries.clear();
  packing.domain.max.y() = 3;
  for (Vec3& place : packing.position) place.y() += 2;
  testing::add_particle(packing, Vec3(0.5, 1, 0.5), 0.9, 0);  // before all others, as seen from the front
  packing.fields.clear();
  write_snapshot(folder / "a.vtkhdf", packing);
  const OpenSnapshot open(folder / "a.vtkhdf");
  ParticleView view = open.view();
  const auto left = std::find_if(view.chunks.begin(), view.chunks.end(), [](const RowChunk& chunk) {
    return chunk.box.min.y() > 1 && chunk.box.max.x() < 0.8;
  });
  REQUIRE(left != view.chunks.end());
  std::vector<Vec3> position(view.position.begin(), view.position.end());
  position[left->first].x() = std::nan("");  // refused where it is looked at
  view.position = position;
  const auto refused = [&](const PictureOptions& options) {
    try {
      draw_particles(view, options);
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  PictureOptions options = testing::bare_picture(View::front);
  CHECK_FALSE(refused(options));  // behind the large one
  options.cull = false;
  CHECK(refused(options));
  options.cull = true;
  options.cut = cut_from_text("y<1.5");
  CHECK(refused(options));  // laid open
  options.cut = cut_from_text(fmt::format("x<{}", left->box.max.x() + 0.01));
  CHECK_FALSE(refused(options));  // cut away
  options.cut = cut_from_text("y<1.5");
  options.view.zoom = 8;
  options.view.focus = Vec3(0.95, 0.5, 0.5);
  CHECK_FALSE(refused(options));  // out of view
}

TEST_CASE("a slice looks at the chunks that its plane meets, and shows the same discs") {
  const testing::TemporaryFolder folder;
  write_snapshot(folder / "a.vtkhdf", crowd(60'000));
  const Snapshot whole = read_snapshot(folder / "a.vtkhdf");
  const OpenSnapshot open(folder / "a.vtkhdf");
  for (const SlicePlane& plane :
       {SlicePlane(2, 0.3), SlicePlane(0, 0.001), SlicePlane(Vec3(0.5, 0.5, 0.5), Vec3(1, 2, 3))}) {
    const std::vector<Disc> discs = slice_discs(open.view(), plane), all = slice_discs(whole, plane);
    REQUIRE(discs.size() == all.size());
    CHECK(discs.size() > 100);
    bool same = true;
    for (std::size_t k = 0; k < discs.size(); ++k) same = same && discs[k].row == all[k].row && discs[k].u == all[k].u;
    CHECK(same);
  }
  ParticleView view = open.view();
  std::vector<Vec3> position(view.position.begin(), view.position.end());
  const auto top =
      std::find_if(view.chunks.begin(), view.chunks.end(), [](const RowChunk& c) { return c.box.min.z() > 0.5; });
  REQUIRE(top != view.chunks.end());
  position[top->first].x() = std::nan("");
  view.position = position;
  CHECK_NOTHROW(slice_discs(view, SlicePlane(2, 0.3)));
  CHECK_THROWS_AS(slice_discs(view, SlicePlane(0, (top->box.min.x() + top->box.max.x()) / 2)), InputError);
}
