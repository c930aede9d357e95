#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "viz/image.hpp"

using namespace packstone;
using namespace packstone::viz;

TEST_CASE("averaging down takes the mean of squares") {
  // Two by four pixels, the upper square is 0, 10, 20, 30, the lower one all 40.
  std::vector<std::uint8_t> pixels;
  for (const int value : {0, 10, 20, 30, 40, 40, 40, 40})
    pixels.insert(pixels.end(), 4, static_cast<std::uint8_t>(value));
  const Layer layer = average_down(pixels.data(), 2, 4, 2);
  REQUIRE(layer.width == 1);
  REQUIRE(layer.height == 2);
  CHECK(layer.rgba[0] == 15);
  CHECK(layer.rgba[4] == 40);
}

TEST_CASE("layers lie over each other by their alpha") {
  const Layer lower{2, 1, {100, 0, 0, 255, 0, 0, 0, 0}};
  const Layer upper{2, 1, {0, 50, 0, 127, 0, 0, 0, 0}};
  const Image image = flatten({&lower, &upper}, {255, 255, 255});
  CHECK(image.at(0, 0) == Colour{50, 50, 0});
  CHECK(image.at(1, 0) == Colour{255, 255, 255});
}

TEST_CASE("the difference of pictures has the stated scale") {
  const Image black{8, 8, std::vector<std::uint8_t>(8 * 8 * 3, 0)};
  Image other = black;
  CHECK(difference(black, other) == 0);
  std::fill(other.rgb.begin(), other.rgb.end(), std::uint8_t{255});
  CHECK(difference(black, other) == Approx(255));
  // A quarter of the picture off by 60 in every channel.
  other = black;
  for (int row = 0; row < 4; ++row) std::fill_n(other.rgb.begin() + row * 8 * 3, 4 * 3, std::uint8_t{60});
  CHECK(difference(black, other) == Approx(15));
  CHECK_THROWS_AS(difference(black, Image{4, 4, std::vector<std::uint8_t>(48)}), InputError);
}
