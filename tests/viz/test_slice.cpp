#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/geometry.hpp"
#include "tests/viz/packings.hpp"
#include "viz/slice.hpp"
#include "viz/svg.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

bool centre_inside(const Disc& disc, const Domain& domain, PlaneAxes axes) {
  return disc.u >= domain.min[axes.u] && disc.u < domain.max[axes.u] && disc.v >= domain.min[axes.v] &&
         disc.v < domain.max[axes.v];
}

}  // namespace

TEST_CASE("the discs of all slices add up to the volume of the spheres") {
  const Snapshot snapshot = testing::layered_packing(1);
  double volume = 0;
  for (const double r : snapshot.radius) volume += sphere_volume(r);
  constexpr int slices = 2000;
  for (int axis = 0; axis < 3; ++axis) {
    const double thickness = snapshot.domain.size()[axis] / slices;
    const PlaneAxes axes = axes_in_plane(axis);
    double sum = 0;
    for (int i = 0; i < slices; ++i) {
      for (const Disc& disc : slice_discs(snapshot, {axis, (i + 0.5) * thickness})) {
        if (centre_inside(disc, snapshot.domain, axes)) sum += M_PI * disc.radius * disc.radius * thickness;
      }
    }
    CHECK(sum == Approx(volume).epsilon(1e-3));
  }
}

TEST_CASE("a disc has the true radius, and images where it sticks out of a periodic side") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  testing::add_particle(snapshot, Vec3(0.05, 0.02, 0.5), 0.1, 0);
  const auto discs = slice_discs(snapshot, {2, 0.56});
  REQUIRE(discs.size() == 4);  // a corner: itself, one image a side and one beyond both
  for (const Disc& disc : discs) CHECK(disc.radius == Approx(0.08));
  // The plane close to the other end cuts the image along its own axis.
  REQUIRE(slice_discs(snapshot, {1, 0.96}).size() == 2);
  CHECK(slice_discs(snapshot, {1, 0.96}).front().radius == Approx(0.08));
  snapshot.domain.periodic = {false, false, false};
  CHECK(slice_discs(snapshot, {2, 0.56}).size() == 1);
  CHECK(slice_discs(snapshot, {1, 0.96}).empty());
}

TEST_CASE("a plane outside the domain is refused") {
  const Snapshot snapshot = testing::layered_packing(1);
  CHECK_THROWS_AS(slice_discs(snapshot, {2, 1.7}), InputError);
  CHECK_THROWS_AS(slice_discs(snapshot, {2, std::nan("")}), InputError);
}

TEST_CASE("a plane is read from text") {
  CHECK(plane_from_text("z=0.1").axis == 2);
  CHECK(plane_from_text(" y = 290 mm").axis == 1);
  CHECK(plane_from_text("y = 290 mm").position == Approx(0.29));
  for (const char* text : {"", "w=1", "z", "z=", "zz=1", "z=high", "z=1 s"})
    CHECK_THROWS_AS(plane_from_text(text), InputError);
}

TEST_CASE("a slice shows the cut particles in their colours, and paper between them") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  testing::add_particle(snapshot, Vec3(0.3, 0.5, 0.3), 0.15, 0);
  testing::add_particle(snapshot, Vec3(0.7, 0.5, 0.7), 0.15, 1);
  SliceOptions options;
  options.width = 400;
  options.height = 300;
  const SlicePlane plane{1, 0.5};
  const Drawing drawing = slice_drawing(snapshot, plane, options);
  const Image image = draw_slice(snapshot, plane, options);
  int discs = 0;
  for (const Mark& mark : drawing.marks) {
    const auto* disc = std::get_if<DiscMark>(&mark);
    if (disc == nullptr || !disc->outline) continue;  // the legend's swatches have none
    const Colour expected = category_colour(static_cast<std::size_t>(discs++));
    CHECK(image.at(static_cast<int>(disc->centre.x), static_cast<int>(disc->centre.y)) == expected);
    const int beside = static_cast<int>(disc->centre.x + 1.15 * disc->radius);
    CHECK(image.at(beside, static_cast<int>(disc->centre.y)) == paper);
  }
  CHECK(discs == 2);
}

TEST_CASE("the SVG of a slice holds a circle for every disc and the labels as text") {
  const Snapshot snapshot = testing::layered_packing(1e-6);
  SliceOptions options;
  options.legend = false;
  const SlicePlane plane{1, 0.29e-6};
  const std::string svg = svg_text(slice_drawing(snapshot, plane, options), "cut <1>");
  std::size_t circles = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++circles;
  CHECK(circles == slice_discs(snapshot, plane).size());
  CHECK(svg.find("y = 0.29 µm") != std::string::npos);
  CHECK(svg.find("x [µm]") != std::string::npos);
  CHECK(svg.find("<title>cut &lt;1&gt;</title>") != std::string::npos);
}

TEST_CASE("an empty packing has an empty slice") {
  CHECK_NOTHROW(draw_slice(testing::empty_box(Vec3::Ones()), {2, 0.5}, {}));
}
