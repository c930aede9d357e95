// Particles cut through, beside a caster that only knows which points are solid, and beside the discs of a slice.
#include <cmath>

#include <catch2/catch.hpp>

#include "core/random.hpp"
#include "tests/viz/bare_picture.hpp"
#include "tests/viz/packings.hpp"
#include "viz/annotation.hpp"
#include "viz/pixel_layer.hpp"
#include "viz/slice.hpp"
#include "viz/sphere_cloud.hpp"
#include "viz/sphere_drawing.hpp"

using namespace packstone;
using namespace packstone::viz;

namespace {

struct CutSpheres {
  std::vector<Vec3> centres;
  std::vector<double> radii;
  std::vector<Colour> colours;
  CutAway cut;

  /// Strewn in the unit box about the origin; of one large radius and many.
  CutSpheres(int count, const std::string& planes) : cut(cut_from_text(planes)) {
    Random random(11, RandomStream::filling_position, 0);
    const auto place = [&] { return random.uniform(-0.5, 0.5); };
    for (int i = 0; i < count; ++i) {
      centres.emplace_back(place(), place(), place());
      radii.push_back(random.uniform(0.02, 0.12));
      colours.push_back({200, 200, 200});
    }
  }

  SphereCloud cloud(const Camera& camera) const {
    SphereRows rows = sphere_rows(centres, radii, colours);
    rows.cut = cut;
    rows.cut_through = true;
    return {rows, camera};
  }
  bool solid(std::size_t sphere, const Vec3& point) const {
    return (point - centres[sphere]).norm() < radii[sphere] && !is_cut_away(cut, point);
  }
};

/// The first solid point of a sphere along a ray: steps, then halving. Infinite where no step meets it.
double first_solid(const CutSpheres& spheres, std::size_t sphere, const Vec3& start, const Vec3& way, double from,
                   double to) {
  constexpr int steps = 400, halvings = 40;
  for (int k = 1; k <= steps; ++k) {
    double out = from + (to - from) * (k - 1) / steps, in = from + (to - from) * k / steps;
    if (!spheres.solid(sphere, start + in * way)) continue;
    for (int h = 0; h < halvings; ++h) {
      const double middle = (out + in) / 2;
      (spheres.solid(sphere, start + middle * way) ? in : out) = middle;
    }
    return in;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

TEST_CASE("every pixel shows what is solid of the spheres that are cut through, at its distance") {
  const PixelWindow window{0, 0, 120, 90};
  const Box region{0, 0, 120, 90};
  for (const char* planes : {"x>0.1", "x>0,y<0.1", "z>0.05,y<0,x<0.2"}) {
    const CutSpheres spheres(40, planes);
    for (const View view : {View::iso, View::front, View::top}) {
      INFO(planes << ", view " << static_cast<int>(view));
      const Camera camera(view, Vec3::Constant(-0.5), Vec3::Constant(0.5), region);
      PixelLayer layer(camera);
      layer.reset(window);
      draw(layer, spheres.cloud(camera));
      int covered = 0, other = 0;
      double worst = 0;
      for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
          const Point middle{column + 0.5, row + 0.5};
          const Vec3 start = camera.point_at(middle, 0), way = camera.point_at(middle, 1) - start;
          double distance = std::numeric_limits<double>::infinity();
          std::uint32_t seen = PixelLayer::nothing;
          for (std::size_t i = 0; i < spheres.centres.size(); ++i) {
            const double nearest = (spheres.centres[i] - start).dot(way) / way.squaredNorm();
            const double reach = spheres.radii[i] / way.norm();
            if ((start + nearest * way - spheres.centres[i]).norm() > spheres.radii[i]) continue;
            const double met = first_solid(spheres, i, start, way, nearest - reach, nearest + reach);
            if (met >= distance) continue;
            distance = met;
            seen = static_cast<std::uint32_t>(i);
          }
          covered += seen != PixelLayer::nothing;
          if (layer.numbers(row)[column] == seen) {
            if (seen != PixelLayer::nothing) worst = std::max(worst, std::abs(layer.distances(row)[column] - distance));
          } else {
            // On a face where two spheres overlap both are met at once.
            other += std::abs(layer.distances(row)[column] - distance) > 1e-6 || seen == PixelLayer::nothing;
          }
        }
      }
      REQUIRE(covered > 1000);
      CHECK(other < 0.0005 * covered);
      CHECK(worst < 3e-6);  // of the box's edge
    }
  }
}

TEST_CASE("looking at the face of a cut, one sees the discs of a slice there") {
  Snapshot packing = testing::layered_packing(1);
  packing.domain.periodic = {false, false, false};  // images are not drawn in space
  packing.boundaries.clear();
  PictureOptions options = testing::bare_picture(View::front, 600, 500);
  options.cut = cut_from_text("y<0.43");
  options.cut_through = true;
  const UnitSpace space(packing.domain);
  const Camera camera = lay_out(options, space, {}).camera;
  ParticlePainter painter(options);
  painter.paint(packing);
  int on_face = 0;
  for (int row = 0; row < options.height; ++row) {
    for (int column = 0; column < options.width; ++column) {
      const auto point = painter.surface_point(column, row);
      on_face += point && std::abs(point->y() - 0.43) < 1e-5;
    }
  }
  double area = 0;
  for (const Disc& disc : slice_discs(packing, {1, 0.43})) area += M_PI * disc.radius * disc.radius;
  const double pixels_a_metre = camera.pixels_per_unit() * space.scale;
  CHECK(on_face == Approx(area * pixels_a_metre * pixels_a_metre).epsilon(0.005));
}

TEST_CASE("tiles, parts and culling change no byte of what is cut through") {
  const Snapshot packing = testing::layered_packing(1);
  PictureOptions options;
  options.width = 301;
  options.height = 207;
  options.cut = cut_from_text("x>0.4,y<0.5");
  options.cut_through = true;
  options.occlusion = 0.7;
  const Image whole = draw_particles(packing, options);
  options.parts = 5;
  options.cull = false;
  ParticlePainter painter(options);
  painter.show(packing);
  Image merged{options.width, options.height, std::vector<std::uint8_t>(whole.rgb.size())};
  for (const PixelWindow& tile : {PixelWindow{0, 0, 100, 207}, {100, 0, 201, 33}, {100, 33, 201, 174}}) {
    place(merged, painter.part(tile), tile.left, tile.top);
  }
  CHECK(merged.rgb == whole.rgb);
  options.cut_through = false;
  CHECK(draw_particles(packing, options).rgb != whole.rgb);
}
