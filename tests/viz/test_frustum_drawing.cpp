// Tubes and cones as pixels beside a slow ray caster that knows only what is inside; tiles and hidden ones byte for
// byte.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "viz/frustum_drawing.hpp"
#include "viz/sphere_drawing.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

/// In the unit box about the origin: tubes, cones and frusta, thin and thick, long and flat.
std::vector<Frustum> strewn_frusta(int count) {
  Random random(7, RandomStream::filling_position, 0);
  const auto place = [&] {
    return Vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
  };
  const auto tone = [&] { return static_cast<std::uint8_t>(random.uniform(0, 255)); };
  std::vector<Frustum> frusta;
  for (int i = 0; i < count; ++i) {
    const Vec3 from = place(), to = from + 1.5 * std::pow(10, random.uniform(-1.5, 0)) * place();
    const double radius = 0.1 * std::pow(10, random.uniform(-1.3, 0));
    const double other[3] = {radius, 0, radius * random.uniform(0, 2)};
    frusta.push_back({from, to, radius, other[i % 3], {tone(), tone(), tone()}});
  }
  return frusta;
}

Camera tube_camera(View view, const PixelWindow& window) {
  return {view, Vec3::Constant(-0.5), Vec3::Constant(0.5),
          Box{0, 0, static_cast<double>(window.width), static_cast<double>(window.height)}};
}

PixelLayer drawn_tubes(const std::vector<Frustum>& frusta, const Camera& camera, const PixelWindow& window, bool cull) {
  PixelLayer layer(camera);
  layer.reset(window);
  draw(layer, FrustumCloud(frusta, camera, 0), cull);
  return layer;
}

/// Below 0 inside, and convex along every line, as a frustum is.
double outside(const Frustum& f, const Vec3& p) {
  const Vec3 axis = (f.to - f.from).normalized();
  const double length = (f.to - f.from).norm(), h = (p - f.from).dot(axis);
  const double radius = f.from_radius + (f.to_radius - f.from_radius) * h / length;
  return std::max({-h, h - length, (p - f.from - h * axis).norm() - radius});
}

struct TubeHit {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t frustum = PixelLayer::nothing;
};

/// The deepest point of the ray in each frustum by golden section, then the way in by bisection.
TubeHit cast_tubes(const std::vector<Frustum>& frusta, const Camera& camera, int column, int row) {
  const Point middle{column + 0.5, row + 0.5};
  const auto at = [&](double distance) { return camera.point_at(middle, distance); };
  TubeHit hit;
  for (std::size_t i = 0; i < frusta.size(); ++i) {
    double low = camera.nearest_distance(), high = camera.farthest_distance() + 1;
    const double start = low;
    constexpr double golden = 0.6180339887498949;
    for (int k = 0; k < 60; ++k) {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      if (outside(frusta[i], at(left)) < outside(frusta[i], at(right))) {
        high = right;
      } else {
        low = left;
      }
    }
    if (outside(frusta[i], at(low)) >= 0) continue;
    double out = start, in = low;
    for (int k = 0; k < 50; ++k) {
      const double half = (out + in) / 2;
      (outside(frusta[i], at(half)) < 0 ? in : out) = half;
    }
    if (in < hit.distance) hit = {in, i};
  }
  return hit;
}

}  // namespace

TEST_CASE("every pixel shows the tube or cone that a ray caster finds, at its distance") {
  const std::vector<Frustum> frusta = strewn_frusta(50);
  const PixelWindow window{0, 0, 160, 120};
  for (const View view : {View::iso, View::front}) {
    const Camera camera = tube_camera(view, window);
    const PixelLayer layer = drawn_tubes(frusta, camera, window, true);
    int covered = 0, other = 0;
    double worst = 0;
    for (int row = 0; row < window.height; ++row) {
      for (int column = 0; column < window.width; ++column) {
        const TubeHit hit = cast_tubes(frusta, camera, column, row);
        covered += hit.frustum != PixelLayer::nothing;
        if (layer.numbers(row)[column] != hit.frustum) {
          ++other;
        } else if (hit.frustum != PixelLayer::nothing) {
          worst = std::max(worst, std::abs(layer.distances(row)[column] - hit.distance));
        }
      }
    }
    REQUIRE(covered > 1500);
    CHECK(other <= 0.0005 * covered);
    CHECK(worst < 1e-5);
  }
}

TEST_CASE("a tube is lit as its surface stands") {
  // Level and across the view: its picture is a strip, lit as a sphere of its radius is along the line from top to
  // bottom.
  const std::vector<Frustum> tube = {{Vec3(-0.4, 0, 0), Vec3(0.4, 0, 0), 0.2, 0.2, {180, 180, 180}}};
  const PixelWindow window{0, 0, 200, 200};
  const Camera camera = tube_camera(View::front, window);
  const PixelLayer layer = drawn_tubes(tube, camera, window, true);
  const std::vector<Vec3> centre = {Vec3::Zero()};
  const std::vector<double> radius = {0.2};
  const std::vector<Colour> colour = {{180, 180, 180}};
  PixelLayer ball(camera);
  ball.reset(window);
  draw(ball, SphereCloud(sphere_rows(centre, radius, colour), camera));
  int compared = 0;
  for (int row = 0; row < window.height; ++row) {
    if (ball.numbers(row)[100] == PixelLayer::nothing) continue;
    REQUIRE(layer.numbers(row)[100] == 0);
    const auto tone = [&](const PixelLayer& of) { return static_cast<double>(of.colours(row)[100] & 0xff); };
    CHECK(tone(layer) == Approx(tone(ball)).margin(2));  // half a pixel beside the sphere's middle
    CHECK(layer.distances(row)[40] == layer.distances(row)[160]);
    ++compared;
  }
  CHECK(compared == 80);
}

TEST_CASE("a window and hidden tubes left out change no bit, among spheres") {
  const std::vector<Frustum> frusta = strewn_frusta(200);
  const std::vector<Vec3> centres = {Vec3(0.1, 0.1, 0), Vec3(-0.2, 0, 0.2)};
  const std::vector<double> radii = {0.15, 0.1};
  const std::vector<Colour> colours = {{255, 0, 0}, {0, 0, 255}};
  const PixelWindow whole{0, 0, 251, 187};
  for (const View view : {View::iso, View::left}) {
    const Camera camera = tube_camera(view, whole);
    const SphereCloud spheres(sphere_rows(centres, radii, colours), camera);
    const FrustumCloud tubes(frusta, camera, 2);
    PixelLayer plain(camera);
    plain.reset(whole);
    draw(plain, tubes, false);
    draw(plain, spheres, false);
    int different = 0, tube_pixels = 0, sphere_pixels = 0;
    for (const PixelWindow& window : {whole, PixelWindow{13, 40, 101, 33}, {120, 0, 1, 187}}) {
      PixelLayer part(camera);
      part.reset(window);
      draw(part, spheres, true);
      draw(part, tubes, true);
      REQUIRE(!part.blank());
      for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
          const int y = window.top + row, x = window.left + column;
          const auto number = plain.numbers(y)[x];
          tube_pixels += number != PixelLayer::nothing && number >= 2;
          sphere_pixels += number < 2;
          different += part.colours(row)[column] != plain.colours(y)[x] || part.numbers(row)[column] != number ||
                       part.distances(row)[column] != plain.distances(y)[x];
        }
      }
    }
    CHECK(different == 0);
    CHECK(tube_pixels > 10'000);
    CHECK(sphere_pixels > 50);
  }
}
