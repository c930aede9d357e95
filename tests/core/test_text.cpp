#include <catch2/catch.hpp>

#include "core/text.hpp"

using namespace packstone;

TEST_CASE("the nearest name is found, a far one is not offered") {
  const std::vector<std::string> names = {"duration", "time_step", "kind"};
  CHECK(nearest_name("durtion", names) == "duration");
  CHECK(nearest_name("timestep", names) == "time_step");
  CHECK_FALSE(nearest_name("gravity", names).has_value());
  CHECK_FALSE(nearest_name("x", {}).has_value());
}

TEST_CASE("words are joined") {
  CHECK(joined({}).empty());
  CHECK(joined({"a"}) == "a");
  CHECK(joined({"a", "b", "c"}) == "a, b, c");
}
