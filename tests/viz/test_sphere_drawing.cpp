// Spheres as pixels beside a slow ray caster in double precision; tiles, parts and hidden spheres byte for byte.
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "tests/viz/packings.hpp"
#include "viz/particle_scene.hpp"
#include "viz/pixel_layer.hpp"
#include "viz/sphere_cloud.hpp"
#include "viz/sphere_drawing.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

struct Spheres {
  std::vector<Vec3> centres;
  std::vector<double> radii;
  std::vector<Colour> colours;

  SphereRows rows() const { return sphere_rows(centres, radii, colours); }
  /// Rows [first, last) of one chunk.
  SphereRows rows(std::size_t first, std::size_t last) const {
    SphereRows part = rows();
    REQUIRE(part.chunks.size() == 1);
    part.chunks = {{first, last, part.chunks[0].box}};
    return part;
  }
};

/// At random in the unit box about the origin, radii over two decades.
Spheres strewn_spheres(int count) {
  Random random(3, RandomStream::filling_position, 0);
  Spheres spheres;
  for (int i = 0; i < count; ++i) {
    spheres.centres.emplace_back(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    spheres.radii.push_back(0.2 * std::pow(10, random.uniform(-2, 0)));
    const auto tone = [&] { return static_cast<std::uint8_t>(random.uniform(0, 255)); };
    spheres.colours.push_back({tone(), tone(), tone()});
  }
  return spheres;
}

Camera camera_of(View view, const PixelWindow& window) {
  return {view, Vec3::Constant(-0.5), Vec3::Constant(0.5),
          Box{0, 0, static_cast<double>(window.width), static_cast<double>(window.height)}};
}

PixelLayer drawn(const Spheres& spheres, const Camera& camera, const PixelWindow& window, bool cull = true) {
  PixelLayer layer(camera);
  layer.reset(window);
  draw(layer, SphereCloud(spheres.rows(), camera), cull);
  return layer;
}

struct Hit {
  double distance = std::numeric_limits<double>::infinity();  // along the camera's axis from the viewer
  std::size_t sphere = PixelLayer::nothing;
};

/// The nearest point of any sphere on a pixel's ray, from two points of the ray and the quadratic equation.
Hit cast(const Spheres& spheres, const Camera& camera, int column, int row) {
  const Point middle{column + 0.5, row + 0.5};
  const Vec3 near = camera.point_at(middle, 1), way = camera.point_at(middle, 2) - near;
  Hit hit;
  for (std::size_t i = 0; i < spheres.centres.size(); ++i) {
    const Vec3 from = near - spheres.centres[i];
    const double a = way.squaredNorm(), b = from.dot(way), c = from.squaredNorm() - spheres.radii[i] * spheres.radii[i];
    const double root = b * b - a * c;
    if (root <= 0) continue;
    const double distance = 1 + (-b - std::sqrt(root)) / a;
    if (distance < hit.distance) hit = {distance, i};
  }
  return hit;
}

bool same(const PixelLayer& a, const PixelLayer& b, int row_of_a, int column_of_a, int row, int column) {
  if (a.blank()) return b.numbers(row)[column] == PixelLayer::nothing;
  return a.colours(row_of_a)[column_of_a] == b.colours(row)[column] &&
         a.distances(row_of_a)[column_of_a] == b.distances(row)[column] &&
         a.numbers(row_of_a)[column_of_a] == b.numbers(row)[column];
}

}  // namespace

TEST_CASE("every pixel shows the sphere that a ray caster finds, at its distance") {
  const Spheres spheres = strewn_spheres(400);
  const PixelWindow window{0, 0, 320, 240};
  for (const View view : {View::iso, View::top, View::right}) {
    const Camera camera = camera_of(view, window);
    const PixelLayer layer = drawn(spheres, camera, window);
    int covered = 0, other_sphere = 0;
    double worst = 0;
    for (int row = 0; row < window.height; ++row) {
      for (int column = 0; column < window.width; ++column) {
        const Hit hit = cast(spheres, camera, column, row);
        covered += hit.sphere != PixelLayer::nothing;
        if (layer.numbers(row)[column] != hit.sphere) {
          ++other_sphere;
        } else if (hit.sphere != PixelLayer::nothing) {
          worst = std::max(worst, std::abs(layer.distances(row)[column] - hit.distance));
        }
      }
    }
    REQUIRE(covered > 20'000);
    CHECK(other_sphere < 0.0005 * covered);  // 0.5 % is asked for
    CHECK(worst < 1e-5);                     // of the box's edge; at grazing rays
  }
}

TEST_CASE("small spheres far away keep their shape") {
  // A row of spheres a ten-thousandth of the picture wide each, under a lens that makes them 30 pixels.
  Spheres spheres;
  for (int i = 0; i < 10; ++i) {
    spheres.centres.emplace_back(0.4 + i * 2e-4, 0.3, 0.2);
    spheres.radii.push_back(1e-4);
    spheres.colours.push_back({255, 255, 255});
  }
  const PixelWindow whole{0, 0, 300'000, 200'000};
  const Camera camera = camera_of(View::iso, whole);
  const Point middle = camera.project(spheres.centres[5]);
  const PixelWindow window{static_cast<int>(middle.x) - 100, static_cast<int>(middle.y) - 40, 200, 80};
  const PixelLayer layer = drawn(spheres, camera, window);
  int covered = 0, wrong = 0;
  for (int row = 0; row < window.height; ++row) {
    for (int column = 0; column < window.width; ++column) {
      const Hit hit = cast(spheres, camera, window.left + column, window.top + row);
      covered += hit.sphere != PixelLayer::nothing;
      wrong += layer.numbers(row)[column] != hit.sphere;
    }
  }
  REQUIRE(covered > 1000);
  CHECK(wrong <= 0.005 * covered);
}

TEST_CASE("the light of a pixel is that of the sphere's normal there") {
  const Spheres one{{Vec3(0.1, 0.2, -0.1)}, {0.3}, {{200, 200, 200}}};
  const PixelWindow window{0, 0, 240, 180};
  for (const View view : {View::iso, View::front}) {
    const Camera camera = camera_of(view, window);
    const PixelLayer layer = drawn(one, camera, window);
    int compared = 0;
    for (int row = 0; row < window.height; row += 7) {
      for (int column = 0; column < window.width; column += 7) {
        const Hit hit = cast(one, camera, column, row);
        if (hit.sphere != 0) continue;
        const Vec3 out = camera.point_at({column + 0.5, row + 0.5}, hit.distance) - one.centres[0];
        const Vec3 n(out.dot(camera.axes()[0]) / 0.3, out.dot(camera.axes()[1]) / 0.3, out.dot(camera.axes()[2]) / 0.3);
        const double light = 0.22 + 0.36 * std::max(0.0, n.z()) + 0.51 * std::max(0.0, n.dot(Vec3(-0.48, 0.69, 0.55))) +
                             0.12 * std::max(0.0, n.dot(Vec3(0.91, 0.18, 0.37)));
        const double shine = 0.1 * std::pow(std::max(0.0, n.dot(Vec3(-0.27, 0.39, 0.88))), 32);
        const double tone = std::min(255.0, 200 * light + 255 * shine);
        CHECK(static_cast<double>(layer.colours(row)[column] & 0xff) == Approx(tone).margin(0.6));
        ++compared;
      }
    }
    CHECK(compared > 30);
  }
}

TEST_CASE("a window, a part of the spheres and hidden spheres left out change no bit") {
  const Spheres spheres = strewn_spheres(3000);
  const PixelWindow whole{0, 0, 301, 207};
  for (const View view : {View::iso, View::bottom}) {
    const Camera camera = camera_of(view, whole);
    const PixelLayer plain = drawn(spheres, camera, whole, false);
    int different = 0;
    for (const PixelWindow& window :
         {PixelWindow{0, 0, 301, 207}, {17, 31, 90, 53}, {150, 0, 151, 207}, {300, 206, 1, 1}}) {
      const PixelLayer part = drawn(spheres, camera, window);
      for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
          different += !same(part, plain, row, column, window.top + row, window.left + column);
        }
      }
    }
    CHECK(different == 0);

    PixelLayer merged(camera);
    merged.reset(whole);
    for (const std::size_t first : {2000, 0, 700}) {  // rows 0-700, 700-2000, 2000-3000, in another order
      const std::size_t rows = first == 0 ? 700 : first == 700 ? 1300 : 1000;
      PixelLayer part(camera);
      part.reset(whole);
      draw(part, SphereCloud(spheres.rows(first, first + rows), camera));
      merged.merge(part);
    }
    for (int row = 0; row < whole.height; ++row) {
      for (int column = 0; column < whole.width; ++column) different += !same(merged, plain, row, column, row, column);
    }
    CHECK(different == 0);
  }
}

TEST_CASE("of spheres in one place the first one is seen, whatever is drawn first") {
  Spheres twins{{Vec3::Zero(), Vec3::Zero()}, {0.3, 0.3}, {{255, 0, 0}, {0, 0, 255}}};
  const PixelWindow window{0, 0, 64, 64};
  const Camera camera = camera_of(View::iso, window);
  PixelLayer layer(camera);
  layer.reset(window);
  for (const std::size_t row : {1, 0}) draw(layer, SphereCloud(twins.rows(row, row + 1), camera));
  CHECK(layer.numbers(32)[32] == 0);
  CHECK((layer.colours(32)[32] & 0xff0000) < (layer.colours(32)[32] & 0xff) << 16);
}

TEST_CASE("tiles of any size and parts of the particles make the same picture, with walls and labels") {
  Snapshot snapshot = testing::layered_packing(1);
  snapshot.boundaries.push_back(testing::upright_cylinder(Vec3(0.5, 0.5, 0), 0.48, 0.9, 64));
  PictureOptions options;
  options.width = 401;
  options.height = 307;
  options.title = "Tiles";
  for (const int supersampling : {1, 2, 3}) {
    options.supersampling = supersampling;
    options.occlusion = supersampling == 1 ? 0 : 0.8;
    options.parts = 1;
    const Image whole = draw_particles(snapshot, options);
    options.parts = 8;
    options.cull = supersampling != 2;
    ParticlePainter painter(options);
    painter.show(snapshot);
    for (const auto& [columns, rows] : {std::pair{1, 1}, {4, 3}, {7, 5}}) {
      Image merged{options.width, options.height, std::vector<std::uint8_t>(whole.rgb.size())};
      for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
          const int left = options.width * i / columns, top = options.height * j / rows;
          const PixelWindow tile{left, top, options.width * (i + 1) / columns - left,
                                 options.height * (j + 1) / rows - top};
          place(merged, painter.part(tile), left, top);
        }
      }
      CHECK(merged.rgb == whole.rgb);
    }
  }
}

TEST_CASE("a window of a picture of 32768 pixels a side is drawn within little memory") {
  PictureOptions options;
  options.width = options.height = 32'768;
  ParticlePainter painter(options);
  const Snapshot snapshot = testing::single_sphere(0.4);
  painter.show(snapshot);
  const Image corner = painter.part({16'000, 16'000, 200, 100});
  CHECK(corner.at(100, 50) != paper);
  const auto point = painter.surface_point(16'100, 16'050);
  REQUIRE(point);
  CHECK((*point - snapshot.position[0]).norm() == Approx(0.4).epsilon(1e-5));
}
