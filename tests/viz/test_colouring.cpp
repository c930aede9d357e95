#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "tests/viz/packings.hpp"
#include "viz/colouring.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::Contains;

TEST_CASE("whole numbers of a field are categories where they are asked for") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  for (int i = 0; i < 4; ++i) testing::add_particle(snapshot, Vec3::Constant(0.2 * i + 0.1), 0.05, 0);
  snapshot.fields["cluster"] = {1, "", {0, 9, -1, 9}};
  const Colouring colouring = colour_particles(snapshot, "category:cluster", {});
  const Colour expected[] = {category_colour(0), category_colour(9), no_value, category_colour(9)};
  REQUIRE(colouring.colours.size() == std::size(expected));
  for (std::size_t row = 0; row < std::size(expected); ++row) CHECK(colouring.colours[row] == expected[row]);
  REQUIRE(colouring.entries.size() == 2);
  CHECK(colouring.entries[1].name == "9");
  CHECK_FALSE(colouring.range);
  CHECK(colours_categories("category:cluster"));
  CHECK_THROWS_AS(colour_particles(snapshot, "category:cluter", {}), InputError);
}

TEST_CASE("categories take the palette and name the groups") {
  const Snapshot snapshot = testing::layered_packing(1);
  const Colouring colouring = colour_particles(snapshot, "type", std::nullopt);
  REQUIRE(colouring.entries.size() == 2);
  CHECK(colouring.entries[0].name == "light");
  CHECK(colouring.colours[0] == category_colour(1));
  CHECK(colouring.colours[snapshot.size() - 1] == category_colour(0));
  CHECK(category_colour(0) != category_colour(1));
}

TEST_CASE("a vector field counts by its magnitude, over its own range or the given one") {
  const Snapshot snapshot = testing::layered_packing(1);
  const auto range = value_range(snapshot, "speed");
  REQUIRE(range);
  CHECK(range->first == Approx(0).margin(1e-12));
  CHECK(range->second == Approx(3));
  CHECK(value_range(snapshot, "velocity") == range);
  const Colouring own = colour_particles(snapshot, "speed", std::nullopt);
  CHECK(own.title == "speed [m/s]");
  CHECK(own.colours[0] == sequential_colour(0));
  CHECK(own.colours[snapshot.size() - 1] == sequential_colour(1));
  const Colouring wide = colour_particles(snapshot, "speed", ValueRange{0, 6});
  CHECK(wide.colours[snapshot.size() - 1] == sequential_colour(0.5));
}

TEST_CASE("a value that is no number has a colour of its own") {
  Snapshot snapshot = testing::single_sphere(0.1);
  snapshot.fields["stress"] = {1, "Pa", {std::nan("")}};
  CHECK(colour_particles(snapshot, "stress", std::nullopt).colours[0] == no_value);
}

TEST_CASE("a missing field is refused with the names there are") {
  const Snapshot snapshot = testing::layered_packing(1);
  CHECK_THROWS_AS(colour_particles(snapshot, "velocty", std::nullopt), InputError);
  CHECK_THROWS_WITH(colour_particles(snapshot, "velocty", std::nullopt),
                    Contains("type, material, radius, speed, velocity") && Contains("did you mean 'velocity'?"));
  CHECK_THROWS_AS(colour_particles(snapshot, "speed", ValueRange{1, 1}), InputError);
}

TEST_CASE("the state in which a run was stopped is coloured by who is behind it") {
  Snapshot snapshot;
  snapshot.position.assign(4, Vec3::Zero());
  snapshot.radius.assign(4, 0.1);
  snapshot.id = {7, 12, 3, 40};
  snapshot.type.assign(4, 0);
  snapshot.material.assign(4, 0);
  snapshot.fields[offender_field] = {1, "", {0, 1, 2, 1}};
  const Colouring colouring = colour_particles(snapshot, offender_field, std::nullopt);
  CHECK(colouring.colours[0] == no_value);
  CHECK(colouring.colours[1] == offending);
  CHECK(colouring.colours[2] == touching);
  CHECK(colouring.entries.front().name == "particles 12, 40");
  CHECK(colours_categories(offender_field));
  snapshot.fields.clear();
  CHECK_THROWS_AS(colour_particles(snapshot, offender_field, std::nullopt), InputError);
}
