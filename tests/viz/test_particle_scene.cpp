#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "tests/viz/bare_picture.hpp"
#include "tests/viz/packings.hpp"
#include "viz/annotation.hpp"
#include "viz/container.hpp"
#include "viz/image.hpp"
#include "viz/particle_scene.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

struct Sight {
  UnitSpace space;
  Camera camera;

  Sight(const Snapshot& snapshot, const PictureOptions& options)
      : space(snapshot.domain), camera(lay_out(options, space, {}).camera) {}

  Point pixel(const Vec3& p) const { return camera.project((p - space.centre) * space.scale); }
  double pixels_per_metre() const { return camera.pixels_per_unit() * space.scale; }
};

int covered_pixels(const Image& image) {
  int count = 0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) count += image.at(column, row) != paper;
  }
  return count;
}

}  // namespace

TEST_CASE("a view by angles, closer, and with its focus in the middle") {
  CHECK(viewpoint_from_text("top") == Viewpoint(View::top));
  CHECK_THROWS_WITH(viewpoint_from_text("10,95"), Catch::Contains("-90 to 90"));
  CHECK_THROWS_AS(viewpoint_from_text("10,20,30"), InputError);
  const Box region{10, 20, 410, 320};
  const Vec3 low = Vec3::Constant(-0.5), high = Vec3::Constant(0.5);
  const auto camera = [&](const std::string& text) { return Camera(viewpoint_from_text(text), low, high, region); };
  CHECK((camera("90,0").axes()[0] - camera("right").axes()[0]).norm() < 1e-12);
  CHECK((camera("0,90").axes()[2] - camera("top").axes()[2]).norm() < 1e-12);
  CHECK((camera("0,-90").axes()[1] - camera("bottom").axes()[1]).norm() < 1e-12);
  CHECK(camera("32,20") == camera("iso"));
  for (const char* name : {"iso", "front", "77,-30"}) {
    Camera closer = camera(name);
    const double before = closer.pixels_per_unit_at(Vec3(0.1, 0.2, 0.3));
    closer.look_closer(2.5, Vec3(0.1, 0.2, 0.3));
    CHECK(closer.pixels_per_unit_at(Vec3(0.1, 0.2, 0.3)) == Approx(2.5 * before));
    const Point middle = closer.project(Vec3(0.1, 0.2, 0.3));
    CHECK(middle.x == Approx(210));
    CHECK(middle.y == Approx(170));
  }
}

TEST_CASE("a closer picture draws nothing over its margins and legend") {
  const Snapshot snapshot = testing::layered_packing(1);
  PictureOptions options;
  options.width = 400;
  options.height = 300;
  options.view = View::front;
  options.view.zoom = 5;
  options.ground = Ground::dark;
  const Image image = draw_particles(snapshot, options);
  const auto frame = lay_out(options, UnitSpace(snapshot.domain), {}).frame;
  REQUIRE(frame);
  const Colour ground = themed(paper, Ground::dark);
  CHECK(image.at(0, 0) == ground);
  int covered = 0;
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < frame->left - 1; ++column) CHECK(image.at(column, row) == ground);
    covered += image.at(frame->left + frame->width / 2, row) != ground;
  }
  CHECK(covered > 250);
}

TEST_CASE("a sphere covers the pixels of its projected disc") {
  const double radius = 0.4;
  const Snapshot snapshot = testing::single_sphere(radius);
  for (const View view : {View::front, View::top, View::left}) {
    const PictureOptions options = testing::bare_picture(view);
    const double pixels = radius * Sight(snapshot, options).pixels_per_metre();
    CHECK(covered_pixels(draw_particles(snapshot, options)) == Approx(M_PI * pixels * pixels).epsilon(0.005));
  }
}

TEST_CASE("the depth of a pixel is where its ray meets the sphere") {
  const double radius = 0.3;
  const Snapshot snapshot = testing::single_sphere(radius);
  for (const View view : {View::iso, View::front}) {
    const PictureOptions options = testing::bare_picture(view);
    ParticlePainter painter(options);
    painter.paint(snapshot);
    const Sight sight(snapshot, options);
    const Point middle = sight.pixel(snapshot.position[0]);
    for (const int offset : {-30, -12, 0, 25}) {
      const int column = static_cast<int>(middle.x) + offset;
      const int row = static_cast<int>(middle.y) + offset / 2;
      const auto point = painter.surface_point(column, row);
      REQUIRE(point);
      // On the sphere, on the pixel's ray, and on the side of the viewer: that is the hit.
      const Vec3 out = *point - snapshot.position[0];
      CHECK(out.norm() == Approx(radius).epsilon(1e-3));
      CHECK(sight.pixel(*point).x == Approx(column + 0.5).margin(0.02));
      CHECK(sight.pixel(*point).y == Approx(row + 0.5).margin(0.02));
      CHECK(sight.camera.axes()[2].dot(out) > 0);
    }
    CHECK_FALSE(painter.surface_point(2, 2));
  }
}

TEST_CASE("a particle has its group's colour where it faces the viewer") {
  Snapshot snapshot = testing::single_sphere(0.4);
  for (const int type : {0, 1}) {
    snapshot.type[0] = type;
    const PictureOptions options = testing::bare_picture(View::front);
    const Image image = draw_particles(snapshot, options);
    const Point middle = Sight(snapshot, options).pixel(snapshot.position[0]);
    const Colour seen = image.at(static_cast<int>(middle.x), static_cast<int>(middle.y));
    const Colour group = category_colour(static_cast<std::size_t>(type));
    // The three lamps give a surface that faces the viewer 0.905 of its colour.
    CHECK(seen.r == Approx(0.905 * group.r).margin(4));
    CHECK(seen.g == Approx(0.905 * group.g).margin(4));
    CHECK(seen.b == Approx(0.905 * group.b).margin(4));
  }
}

TEST_CASE("leaving out hidden particles changes no byte") {
  Snapshot snapshot = testing::layered_packing(1);
  // A large sphere before smaller ones, and one that reaches out of the picture.
  testing::add_particle(snapshot, Vec3(0.5, 0.1, 0.6), 0.3, 0);
  testing::add_particle(snapshot, Vec3(0.5, 0.5, 1.7), 0.4, 1);
  for (const View view : {View::iso, View::top, View::bottom, View::right}) {
    PictureOptions options = testing::bare_picture(view);
    options.supersampling = 2;
    const Image fast = draw_particles(snapshot, options);
    options.cull = false;
    CHECK(draw_particles(snapshot, options).rgb == fast.rgb);
  }
}

TEST_CASE("micrometres look like metres") {
  PictureOptions options = testing::bare_picture(View::iso);
  options.container = true;
  const Image metres = draw_particles(testing::layered_packing(1), options);
  CHECK(difference(draw_particles(testing::layered_packing(1e-6), options), metres) < 0.01);
  CHECK(difference(draw_particles(testing::layered_packing(1e-9), options), metres) < 0.01);
}

TEST_CASE("the view stands still whatever the particles do") {
  const PictureOptions options = testing::bare_picture(View::iso);
  const Snapshot full = testing::layered_packing(1);
  const Snapshot empty = testing::empty_box(full.domain.max);
  const Point a = Sight(full, options).pixel(Vec3(0.3, 0.2, 0.1));
  const Point b = Sight(empty, options).pixel(Vec3(0.3, 0.2, 0.1));
  CHECK(a.x == b.x);
  CHECK(a.y == b.y);
}

TEST_CASE("a box without particles is drawn") {
  PictureOptions options = testing::bare_picture(View::iso);
  const Snapshot snapshot = testing::empty_box(Vec3(1, 1, 2));
  CHECK(covered_pixels(draw_particles(snapshot, options)) == 0);
  options.container = true;
  CHECK(covered_pixels(draw_particles(snapshot, options)) > 100);
  for (const char* color : {"type", "material", "radius"}) {
    options.color = color;
    options.legend = options.time = options.scale = options.axes = true;
    CHECK_NOTHROW(draw_particles(snapshot, options));
  }
}

TEST_CASE("a painter draws the same picture twice, and others in between") {
  PictureOptions options = testing::bare_picture(View::iso);
  options.legend = options.time = options.container = true;
  ParticlePainter painter(options);
  const Image first = painter.paint(testing::layered_packing(1));
  const Image other = painter.paint(testing::single_sphere(0.2));
  CHECK(painter.paint(testing::layered_packing(1)).rgb == first.rgb);
  CHECK(other.rgb != first.rgb);
}

TEST_CASE("the floor does not hide the particles from below") {
  Snapshot snapshot = testing::single_sphere(0.4);
  snapshot.boundaries = {{"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}};
  PictureOptions options = testing::bare_picture(View::bottom);
  options.container = true;
  const Image below = draw_particles(snapshot, options);
  const Point middle = Sight(snapshot, options).pixel(snapshot.position[0]);
  CHECK(below.at(static_cast<int>(middle.x), static_cast<int>(middle.y)) != plate_fill);
  const Point corner = Sight(snapshot, options).pixel(Vec3(0.05, 0.05, 0));
  CHECK(below.at(static_cast<int>(corner.x), static_cast<int>(corner.y)) == paper);
  options.view = View::top;
  const Image above = draw_particles(snapshot, options);
  const Point seen = Sight(snapshot, options).pixel(Vec3(0.05, 0.05, 0));
  CHECK(above.at(static_cast<int>(seen.x), static_cast<int>(seen.y)) == plate_fill);
}

TEST_CASE("a cylinder shows what lies in it, before its far wall") {
  Snapshot snapshot = testing::single_sphere(0.2);
  PictureOptions options = testing::bare_picture(View::front);
  options.container = true;
  options.supersampling = 3;  // so that no line is missed
  const Sight sight(snapshot, options);
  const auto colour_at = [&](const Image& image, const Vec3& p) {
    const Point pixel = sight.pixel(p);
    return image.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  };
  const Vec3 beside(0.22, 0.5, 0.45), outside(0.05, 0.5, 0.45), silhouette(0.9, 0.5, 0.45);
  const Colour bare_sphere = colour_at(draw_particles(snapshot, options), snapshot.position[0]);

  snapshot.boundaries = {testing::upright_cylinder(Vec3(0.5, 0.5, 0.1), 0.4, 0.8, 64)};
  const Image image = draw_particles(snapshot, options);
  CHECK(colour_at(image, snapshot.position[0]) == bare_sphere);
  CHECK(colour_at(image, outside) == paper);
  const Colour far_wall = colour_at(image, beside);
  CHECK(far_wall.r == far_wall.g);
  CHECK(far_wall.r > 170);
  CHECK(far_wall.r < plate_fill.r);
  // Lit from the left: the wall's left part turns away from the light.
  CHECK(far_wall.r < colour_at(image, Vec3(0.78, 0.5, 0.45)).r);
  bool lined = false;  // somewhere in the three pixels around the silhouette
  for (const double off : {-1.0, 0.0, 1.0}) {
    const Vec3 p = silhouette + off / sight.pixels_per_metre() * Vec3::UnitX();
    lined = lined || colour_at(image, p).r < 190;
  }
  CHECK(lined);

  snapshot.boundaries[0].one_sided = false;
  const Colour near_wall = colour_at(draw_particles(snapshot, options), snapshot.position[0]);
  CHECK(near_wall.r == near_wall.g);
  CHECK(near_wall.r > 170);
}

TEST_CASE("the depth of a pixel is that of the wall it shows") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  snapshot.boundaries = {testing::upright_cylinder(Vec3(0.5, 0.5, 0.1), 0.4, 0.8, 64)};
  PictureOptions options = testing::bare_picture(View::front);
  options.container = true;
  ParticlePainter painter(options);
  painter.paint(snapshot);
  const Point pixel = Sight(snapshot, options).pixel(Vec3(0.6, 0.5, 0.5));
  const auto point = painter.surface_point(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  REQUIRE(point);
  CHECK(point->y() == Approx(0.5 + std::sqrt(0.16 - 0.01)).margin(2e-3));
}

TEST_CASE("a floor in the plane of another does not flicker through it") {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  snapshot.boundaries.push_back(testing::upright_cylinder(Vec3(0.5, 0.5, 0), 0.4, 0.8, 64));
  for (const View view : {View::top, View::iso}) {
    PictureOptions options = testing::bare_picture(view);
    options.container = true;
    const Image image = draw_particles(snapshot, options);
    const Sight sight(snapshot, options);
    std::set<int> tones;
    for (double x = 0.35; x < 0.65; x += 0.01) {
      for (double y = 0.35; y < 0.65; y += 0.01) {
        const Point pixel = sight.pixel(Vec3(x, y, 0));
        tones.insert(image.at(static_cast<int>(pixel.x), static_cast<int>(pixel.y)).r);
      }
    }
    CHECK(tones.size() == 1);
  }
}

TEST_CASE("a surface beyond the domain does not move the view") {
  PictureOptions options = testing::bare_picture(View::iso);
  options.container = true;
  Snapshot snapshot = testing::single_sphere(0.3);
  const Image alone = draw_particles(snapshot, options);
  snapshot.boundaries = {testing::upright_cylinder(Vec3(0.5, 2.5, -1), 0.5, 1, 64)};
  const Image beside = draw_particles(snapshot, options);
  const Point middle = Sight(snapshot, options).pixel(snapshot.position[0]);
  CHECK(beside.rgb != alone.rgb);
  for (const int off : {-20, 0, 20}) {
    const int column = static_cast<int>(middle.x) + off;
    CHECK(beside.at(column, static_cast<int>(middle.y)) == alone.at(column, static_cast<int>(middle.y)));
  }
}

TEST_CASE("a plane is cut off at the box") {
  const Vec3 low = Vec3::Zero();
  const Vec3 high = Vec3(1, 1, 2);
  CHECK(plane_in_box(low, Vec3::UnitZ(), low, high).size() == 4);
  CHECK(plane_in_box(Vec3(0, 0, 3), Vec3::UnitZ(), low, high).empty());
  CHECK(plane_in_box(Vec3(0.5, 0.5, 1), Vec3(1, 1, 0.5).normalized(), low, high).size() == 6);
  CHECK(plane_in_box(Vec3(0.1, 0, 0), Vec3(1, 1, 1).normalized(), low, high).size() == 3);
}

TEST_CASE("what is cut away shows what lies behind it") {
  Snapshot snapshot = testing::single_sphere(0.1);
  testing::add_particle(snapshot, Vec3(0.5, 0.2, 0.5), 0.3, 1);  // before the first, as seen from the front
  PictureOptions options = testing::bare_picture(View::front);
  const Point middle = Sight(snapshot, options).pixel(snapshot.position[0]);
  const auto seen = [&](const std::string& cut) {
    options.cut = cut_from_text(cut);
    const Colour colour = draw_particles(snapshot, options).at(static_cast<int>(middle.x), static_cast<int>(middle.y));
    for (const std::size_t type : {0, 1}) {
      if (std::abs(colour.r - 0.905 * category_colour(type).r) < 6) return static_cast<int>(type);
    }
    return colour == paper ? -1 : -2;
  };
  CHECK(seen("") == 1);
  CHECK(seen("y<0.3") == 0);
  CHECK(seen("y > 300 mm") == 1);
  CHECK(seen("y<0.3,x>0.6") == 1);  // a corner that holds no centre
  CHECK(seen("y < 30 cm, x < 0.6 m") == 0);
  CHECK(seen("z<1") == -1);
  for (const char* bad : {"y", "w>1", "y=0.2", "x>0.3,", "x>,y<1", "x>3 kg", ","}) {
    CHECK_THROWS_AS(cut_from_text(bad), InputError);
  }
}

TEST_CASE("bad options are refused") {
  CHECK_THROWS_AS(view_named("above"), InputError);
  CHECK(view_named("bottom") == View::bottom);
  PictureOptions options = testing::bare_picture(View::iso);
  options.color = "charge";
  CHECK_THROWS_AS(draw_particles(testing::layered_packing(1), options), InputError);
  options.supersampling = 0;
  CHECK_THROWS_AS(ParticlePainter(options), InputError);
}
