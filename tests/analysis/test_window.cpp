// The homogeneous part of a packing, where boundaries stand around it and in it.
#include <cmath>

#include <catch2/catch.hpp>

#include "analysis/structure/window.hpp"
#include "core/bed.hpp"
#include "tests/analysis/random_packings.hpp"

using namespace packstone;
using namespace packstone::analysis;
using namespace packstone::fixtures;

namespace {

Snapshot bed(std::array<bool, 3> periodic) { return ideal_gas(4000, Vec3(10, 12, 20), periodic, 1); }

WindowOrReason window_of(const Snapshot& s, double inset = 0) { return bulk_window(s, make_context(s), inset); }

}  // namespace

TEST_CASE("the window of a periodic box is the box, of a bed its bulk") {
  CHECK(window_of(bed({true, true, true}), 1).window->volume() == Approx(2400));
  const Snapshot s = bed({true, false, false});
  const double height = make_context(s).bed.height;
  const Window w = *window_of(s, 0.5).window;
  CHECK(w.periodic == std::array{true, false, false});
  CHECK(w.min.isApprox(Vec3(0, 0.5, bulk_lower * height), 1e-12));
  CHECK(w.max.isApprox(Vec3(10, 11.5, bulk_upper * height), 1e-12));
}

TEST_CASE("gravity upwards turns the window over") {
  Snapshot s = bed({true, true, false});
  s.gravity = Vec3(0, 0, 9.8);
  const double height = make_context(s).bed.height;
  const Window w = *window_of(s).window;
  CHECK(w.max.z() == Approx(20 - bulk_lower * height));
  CHECK(w.min.z() == Approx(std::max(0.0, 20 - bulk_upper * height)));
}

TEST_CASE("boundaries cut and shrink the window") {
  Snapshot s = bed({false, false, false});
  const double height = make_context(s).bed.height;
  SECTION("upright planes along the axes") {
    s.boundaries = {{"low", "plane", Vec3(1, 0, 0), Vec3::UnitX()}, {"high", "plane", Vec3(0, 11, 0), -Vec3::UnitY()}};
    const Window w = *window_of(s).window;
    CHECK(w.min.x() == 1);
    CHECK(w.max.y() == 11);
    CHECK(w.max.x() == 10);
  }
  SECTION("a slanted plane: the box touches it") {
    const Vec3 normal = Vec3(0.8, 0, 0.6);
    s.boundaries = {{"slope", "plane", Vec3(3, 0, 0), normal}};
    const Window w = *window_of(s).window;
    const Vec3 low(w.min.x(), 6, w.min.z());
    CHECK(normal.dot(low - Vec3(3, 0, 0)) == Approx(0).margin(1e-12));
    CHECK(w.max.x() - 5 == Approx(5 - w.min.x()));
  }
  SECTION("a prism: the box inscribed, with the domain's proportions") {
    s.boundaries = {prism(4, Vec3(5, 6, 0), 4, -1, 30)};  // |x| + |y| = 4
    const Window w = *window_of(s).window;
    // Half sides 5 k and 6 k with 5 k + 6 k = 4.
    CHECK(w.size().x() == Approx(2 * 5 * 4 / 11.0));
    CHECK(w.size().y() == Approx(2 * 6 * 4 / 11.0));
  }
  SECTION("a prism of many facets: the circle's box") {
    s.boundaries = {prism(720, Vec3(5, 6, 0), 4, -1, 30)};
    CHECK(std::hypot(window_of(s).window->size().x(), window_of(s).window->size().y()) == Approx(8).epsilon(1e-4));
  }
  SECTION("what stands above or below the bulk does not matter") {
    BoundaryRecord lid = prism(4, Vec3(5, 6, 0), 1, bulk_upper * height + 0.01, 30);
    s.boundaries = {lid};
    CHECK(window_of(s).window->size().x() == Approx(10));
  }
  SECTION("a plate across the middle leaves no window, nor does too large an inset") {
    BoundaryRecord plate{"plate", "mesh"};
    plate.points = {Vec3(0, 0, height / 2), Vec3(30, 0, height / 2), Vec3(0, 30, height / 2)};
    plate.triangles = {{0, 1, 2}};
    CHECK(window_of(s, 5).reason == "no box in the bulk is free of boundaries");
    s.boundaries = {plate};
    CHECK_FALSE(window_of(s).window);
    CHECK(window_of(s).reason == "no box in the bulk is free of boundaries");
  }
  SECTION("no bed, no window") { CHECK(window_of(empty_box(Vec3(1, 1, 1))).reason == "no particles"); }
}
