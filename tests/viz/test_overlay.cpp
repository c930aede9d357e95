// Contacts, arrows and paths among the particles.
#include <cmath>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/viz/bare_picture.hpp"
#include "tests/viz/packings.hpp"
#include "viz/annotation.hpp"
#include "viz/overlay.hpp"
#include "viz/overlay_bodies.hpp"
#include "viz/particle_scene.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

/// Two spheres side by side in the middle, which touch with 5 N; the second presses on the floor with 20 N.
Snapshot touching_pair() {
  Snapshot snapshot = testing::empty_box(Vec3::Ones());
  snapshot.boundaries.clear();
  testing::add_particle(snapshot, Vec3(0.4, 0.5, 0.5), 0.1, 0);
  testing::add_particle(snapshot, Vec3(0.6, 0.5, 0.5), 0.1, 1);
  Contacts contacts;
  contacts.first = {0, 1};
  contacts.second = {1, -1};
  contacts.force = {Vec3(-3, 4, 0), Vec3(0, 0, 20)};
  contacts.normal = {-Vec3::UnitX(), Vec3::UnitZ()};
  contacts.overlap = {0, 0};
  contacts.point = {Vec3(0.5, 0.5, 0.5), Vec3(0.6, 0.5, 0.4)};
  snapshot.contacts = contacts;
  return snapshot;
}

Point pixel_of(const Snapshot& snapshot, const PictureOptions& options, const Vec3& p) {
  const UnitSpace space(snapshot.domain);
  return lay_out(options, space, {}).camera.project((p - space.centre) * space.scale);
}

}  // namespace

TEST_CASE("a way over periodic sides is cut into pieces inside the domain") {
  Domain domain;
  domain.min = Vec3(-1, 0, 2);
  domain.max = Vec3(1, 3, 3);
  domain.periodic = {true, true, false};
  Random random(1, RandomStream::filling_position, 0);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 from(random.uniform(-1, 1), random.uniform(0, 3), random.uniform(2, 3));
    const Vec3 way(random.uniform(-1.5, 1.5), random.uniform(-2, 2), random.uniform(-0.5, 0.5));
    Vec3 gone = Vec3::Zero();
    for (const auto& [start, stop] : pieces_inside(domain, from, way)) {
      CHECK(domain.separation(start, from + gone).norm() < 1e-12);
      for (int k = 0; k < 2; ++k) {
        CHECK(std::min(start[k], stop[k]) >= domain.min[k] - 1e-12);
        CHECK(std::max(start[k], stop[k]) <= domain.max[k] + 1e-12);
      }
      CHECK((stop - start).cross(way).norm() < 1e-12);
      gone += stop - start;
    }
    CHECK((gone - way).norm() < 1e-12);
  }
  CHECK(pieces_inside(domain, Vec3(0, 1, 2.5), Vec3(0.1, 0, 0)).size() == 1);
  CHECK(pieces_inside(domain, Vec3(0.95, 1, 2.5), Vec3(0.1, 0, 0)).size() == 2);
}

TEST_CASE("contacts become links from centre to centre, and to the wall, by their force") {
  Snapshot snapshot = touching_pair();
  const SegmentSet links = contact_links(snapshot);
  REQUIRE(links.segments.size() == 2);
  CHECK(links.segments[0].value == Approx(5));
  CHECK((links.segments[0].way - Vec3(0.2, 0, 0)).norm() < 1e-12);
  CHECK((links.segments[1].way - Vec3(0, 0, -0.1)).norm() < 1e-12);
  CHECK(links.quantile(1) == Approx(20));
  CHECK(links.quantile(0.5) == Approx(5));
  CHECK(SegmentSet{}.quantile(0.5) == 0);

  snapshot.position[0].x() = 0.05;  // now they touch over the periodic side
  snapshot.position[1].x() = 0.9;
  CHECK((contact_links(snapshot).segments[0].way - Vec3(-0.15, 0, 0)).norm() < 1e-12);

  snapshot.contacts->second[0] = 17;  // not in the part that was read
  CHECK(contact_links(snapshot).segments.size() == 1);
  snapshot.contacts.reset();
  CHECK_THROWS_AS(contact_links(snapshot), InputError);
}

TEST_CASE("arrows have the length and direction of their vectors") {
  Snapshot snapshot = touching_pair();
  snapshot.fields["force"] = {3, "N", {0, 0, -2, 3, 4, 0}};
  const SegmentSet forces = arrows_of(snapshot, "force");
  CHECK(forces.title == "force [N]");
  REQUIRE(forces.segments.size() == 2);
  CHECK(forces.segments[1].value == Approx(5));
  const SegmentSet accelerations = arrows_of(snapshot, "acceleration");
  const double mass = 4. / 3 * M_PI * 0.001 * 2400;
  CHECK(accelerations.segments[1].value == Approx(5 / mass));
  CHECK_THROWS_WITH(arrows_of(snapshot, "velocity"), Catch::Contains("force, acceleration"));
  snapshot.fields.clear();
  CHECK_THROWS_WITH(arrows_of(snapshot, "velocity"), Catch::Contains("[output]"));

  // The longest arrow of six mean radii; its tip alone has no width.
  snapshot.fields["force"] = {3, "N", {0, 0, -2, 3, 4, 0}};
  const Overlay overlay{{}, arrows_of(snapshot, "force"), {}};
  const UnitSpace space(snapshot.domain);
  const OverlayBodies bodies(overlay, snapshot, space, colour_particles(snapshot, "type", {}),
                             testing::bare_picture(View::front));
  REQUIRE(bodies.frusta.size() == 4);
  const Vec3 tip = bodies.frusta[3].to / space.scale + space.centre;
  CHECK((tip - Vec3(0.6 + 0.36, 0.5 + 0.48, 0.5)).norm() < 1e-12);
  CHECK(bodies.frusta[3].to_radius == 0);
  const Vec3 shorter = bodies.frusta[1].to / space.scale + space.centre;
  CHECK((shorter - Vec3(0.4, 0.5, 0.5 - 0.24)).norm() < 1e-12);
}

TEST_CASE("tubes stand in the picture where the contacts are, as thick as their forces say") {
  const Snapshot snapshot = touching_pair();
  PictureOptions options = testing::bare_picture(View::front);
  options.shown = Shown::hidden;
  options.look.thickest_force = 20;
  options.look.link_width = 0.4;  // of 0.1 m: 40 mm at 20 N, 10 mm at 5 N
  ParticlePainter painter(options);
  const Image image = painter.paint(snapshot, {contact_links(snapshot), {}, {}});
  const auto thickness = [&](const Vec3& at, bool upright) {  // pixels that are not paper across the tube
    const Point p = pixel_of(snapshot, options, at);
    int count = 0;
    for (int k = -60; k <= 60; ++k) {
      const int column = static_cast<int>(p.x) + (upright ? k : 0), row = static_cast<int>(p.y) + (upright ? 0 : k);
      count += image.at(column, row) != paper;
    }
    return count;
  };
  const double metre =
      pixel_of(snapshot, options, Vec3(1, 0.5, 0.5)).x - pixel_of(snapshot, options, Vec3(0, 0.5, 0.5)).x;
  CHECK(thickness(Vec3(0.5, 0.5, 0.5), false) == Approx(0.02 * metre).margin(1.01));
  CHECK(thickness(Vec3(0.6, 0.5, 0.44), true) == Approx(0.08 * metre).margin(1.01));
  const auto seen = painter.surface_point(static_cast<int>(pixel_of(snapshot, options, Vec3(0.5, 0.5, 0.5)).x),
                                          static_cast<int>(pixel_of(snapshot, options, Vec3(0.5, 0.5, 0.5)).y));
  REQUIRE(seen);
  CHECK(seen->y() == Approx(0.5 - 0.01).margin(1e-3));  // the tube's front

  options.cut = cut_from_text("x<0.55");
  const Image cut = ParticlePainter(options).paint(snapshot, {contact_links(snapshot), {}, {}});
  const Point gone = pixel_of(snapshot, options, Vec3(0.5, 0.5, 0.5)),
              kept = pixel_of(snapshot, options, Vec3(0.6, 0.5, 0.44));
  CHECK(cut.at(static_cast<int>(gone.x), static_cast<int>(gone.y)) == paper);
  CHECK(cut.at(static_cast<int>(kept.x), static_cast<int>(kept.y)) != paper);
}

TEST_CASE("particles with paths keep their size where the others are hidden or shrunk") {
  const Snapshot snapshot = touching_pair();
  PictureOptions options = testing::bare_picture(View::front);
  const Overlay overlay{{}, {}, {{1, {Vec3(0.6, 0.5, 0.9), Vec3(0.6, 0.5, 0.7), Vec3(0.6, 0.5, 0.5)}}}};
  const auto width_at = [&](const Image& image, const Vec3& centre) {
    const Point p = pixel_of(snapshot, options, centre);
    int count = 0;
    for (int k = -25; k <= 25; ++k) {
      count += image.at(static_cast<int>(p.x) + k, static_cast<int>(p.y)) != paper;
    }
    return count;
  };
  const double metre =
      pixel_of(snapshot, options, Vec3(1, 0.5, 0.5)).x - pixel_of(snapshot, options, Vec3(0, 0.5, 0.5)).x;
  options.shown = Shown::hidden;
  const Image hidden = ParticlePainter(options).paint(snapshot, overlay);
  CHECK(width_at(hidden, snapshot.position[0]) == 0);
  CHECK(width_at(hidden, snapshot.position[1]) == Approx(0.2 * metre).margin(1.5));
  CHECK(width_at(hidden, Vec3(0.6, 0.5, 0.85)) > 0);
  CHECK(width_at(hidden, Vec3(0.6, 0.5, 0.85)) < width_at(hidden, Vec3(0.6, 0.5, 0.63)));
  options.shown = Shown::shrunk;
  const Image shrunk = ParticlePainter(options).paint(snapshot, overlay);
  CHECK(width_at(shrunk, snapshot.position[0]) == Approx(0.2 * shrunk_share * metre).margin(1.5));
}

TEST_CASE("tiles of a picture with links, arrows and paths are those of the whole") {
  Snapshot snapshot = touching_pair();
  snapshot.fields["force"] = {3, "N", {0, 0, -2, 3, 4, 0}};
  snapshot.boundaries.push_back(testing::upright_cylinder(Vec3(0.5, 0.5, 0), 0.48, 0.9, 64));
  PictureOptions options;
  options.width = 301;
  options.height = 217;
  options.shown = Shown::shrunk;
  options.occlusion = 0.7;
  const Overlay overlay{contact_links(snapshot),
                        arrows_of(snapshot, "force"),
                        {{1, {Vec3(0.9, 0.9, 0.9), Vec3(0.05, 0.8, 0.7), Vec3(0.6, 0.5, 0.5)}}}};
  ParticlePainter painter(options);
  const Image whole = painter.paint(snapshot, overlay);
  options.parts = 2;
  options.cull = false;
  ParticlePainter other(options);
  other.show(snapshot, overlay);
  Image merged{options.width, options.height, std::vector<std::uint8_t>(whole.rgb.size())};
  for (int left = 0; left < options.width; left += 83) {
    for (int top = 0; top < options.height; top += 61) {
      const PixelWindow tile{left, top, std::min(83, options.width - left), std::min(61, options.height - top)};
      place(merged, other.part(tile), left, top);
    }
  }
  CHECK(merged.rgb == whole.rgb);
}
