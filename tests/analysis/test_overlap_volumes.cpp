// Spheres cut by boxes and cylinders, against quadrature over sections.
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include "analysis/packing/overlap_volume.hpp"
#include "core/geometry.hpp"
#include "core/random.hpp"
#include "tests/analysis/quadrature.hpp"

using namespace packstone;
using analysis::sphere_box_volume;
using analysis::sphere_cylinder_volume;
using fixtures::quadrature;

namespace {

using Real = long double;
constexpr Real circle_constant = std::numbers::pi_v<Real>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Integral of sqrt(r^2 - x^2) from 0.
Real under_circle(Real r, Real x) {
  x = std::clamp(x, -r, r);
  return (x * std::sqrt(std::max(0.0L, r * r - x * x)) +
          r * r * std::atan2(x, std::sqrt(std::max(0.0L, r * r - x * x)))) /
         2;
}

/// Area of a disc about the origin where x < a and y < b.
Real disc_quarter(Real r, Real a, Real b) {
  a = std::clamp(a, -r, r);
  b = std::clamp(b, -r, r);
  const Real x = std::sqrt(std::max(0.0L, r * r - b * b));  // the line y = b leaves the disc at -x, x
  const auto both = [&](Real from, Real to) {
    return to > from ? 2 * (under_circle(r, to) - under_circle(r, from)) : 0.0L;
  };
  const auto cut = [&](Real from, Real to) {
    return to > from ? b * (to - from) + under_circle(r, to) - under_circle(r, from) : 0.0L;
  };
  const Real middle = cut(-x, std::min(a, x));
  return b >= 0 ? both(-r, std::min(a, -x)) + middle + both(x, a) : middle;
}

Real disc_rectangle(Real r, const Vec3& low, const Vec3& high) {
  return disc_quarter(r, high.x(), high.y()) - disc_quarter(r, low.x(), high.y()) - disc_quarter(r, high.x(), low.y()) +
         disc_quarter(r, low.x(), low.y());
}

/// Heights at which a sphere's section has a radius.
void add_heights(std::vector<Real>& heights, Real r, Real section) {
  if (!(std::abs(section) < r)) return;
  const Real z = std::sqrt(r * r - section * section);
  heights.insert(heights.end(), {-z, z});
}

Real box_by_sections(const Vec3& centre, double radius, const Vec3& min, const Vec3& max) {
  const Vec3 low = min - centre, high = max - centre;
  std::vector<Real> kinks = {0};
  for (Real x : {low.x(), high.x()}) {
    add_heights(kinks, radius, x);
    for (Real y : {low.y(), high.y()}) {
      add_heights(kinks, radius, y);
      add_heights(kinks, radius, std::sqrt(x * x + y * y));
    }
  }
  const Real r = radius;
  return quadrature(std::max<Real>(-r, low.z()), std::min<Real>(r, high.z()), kinks,
                    [&](Real z) { return disc_rectangle(std::sqrt(std::max(0.0L, r * r - z * z)), low, high); });
}

/// Area that two circles share, centres a distance d apart.
Real lens_area(Real a, Real b, Real d) {
  if (d >= a + b) return 0;
  if (d <= std::abs(a - b)) return circle_constant * std::min(a, b) * std::min(a, b);
  const auto half_angle = [&](Real r, Real other) {  // of r's arc inside the other circle
    const Real sine2 = (other - r + d) * (other + r - d), cosine2 = (r + d - other) * (r + d + other);
    return 2 * std::atan2(std::sqrt(std::max(0.0L, sine2)), std::sqrt(std::max(0.0L, cosine2)));
  };
  const auto segment = [](Real r, Real angle) { return r * r * (angle - std::sin(2 * angle) / 2); };
  return segment(a, half_angle(a, b)) + segment(b, half_angle(b, a));
}

Real cylinder_by_sections(double radius, const analysis::CylinderPart& c) {
  const Real r = radius, R = c.radius, d = c.distance;
  std::vector<Real> kinks = {0};
  add_heights(kinks, r, R - d);
  add_heights(kinks, r, R + d);
  return quadrature(std::max<Real>(-r, c.lower), std::min<Real>(r, c.upper), kinks,
                    [&](Real z) { return lens_area(std::sqrt(std::max(0.0L, (r - z) * (r + z))), R, d); });
}

}  // namespace

TEST_CASE("sphere and box agree with quadrature") {
  Random random(1, RandomStream::filling_position, 0);
  double worst = 0;
  for (int k = 0; k < 300; ++k) {
    const double radius = random.uniform(0.2, 1.5);
    Vec3 centre, min, max;
    for (int a = 0; a < 3; ++a) {
      centre[a] = random.uniform(-1, 1);
      min[a] = random.uniform(-1.5, 0.5);
      max[a] = min[a] + random.uniform(0.01, 1.5);
    }
    const double expected = static_cast<double>(box_by_sections(centre, radius, min, max));
    worst = std::max(worst, std::abs(sphere_box_volume(centre, radius, min, max) - expected) / sphere_volume(radius));
  }
  CHECK(worst < 1e-14);
}

TEST_CASE("sphere and cylinder agree with quadrature") {
  Random random(2, RandomStream::filling_position, 0);
  const bool whole = GENERATE(as<bool>{}, true, false);
  double worst = 0;
  for (int k = 0; k < 700; ++k) {
    const double radius = std::exp2(random.uniform(-5, 2));
    const double big = std::exp2(random.uniform(-2, 2));
    const double distance = std::max(0.0, big + radius * random.uniform(-1, 1));
    const double lower = whole ? -infinity : radius * random.uniform(-1.1, 0.9);
    const double upper = whole ? infinity : lower + radius * random.uniform(0.01, 2);
    const analysis::CylinderPart c{distance, big, lower, upper};
    const double expected = static_cast<double>(cylinder_by_sections(radius, c));
    worst = std::max(worst, std::abs(sphere_cylinder_volume(radius, c) - expected) / sphere_volume(radius));
  }
  CHECK(worst < (whole ? 5e-14 : 1e-11));
}

TEST_CASE("cylinders that nearly touch a sphere or its centre keep their digits") {
  const double touch = GENERATE(as<double>{}, 0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.03);
  const double sign = GENERATE(as<double>{}, -1, 1);
  const double big = GENERATE(0.01, 0.3, 0.5, 1.0, 3.0);
  // Touching from outside, the cylinder through the centre, the sphere's circle about the cylinder's, and coaxial.
  const double distance = std::max(0.0, sign * touch + GENERATE_COPY(big + 1, big, 1 - big, 0.0));
  const double upper = GENERATE(as<double>{}, infinity, 0.999, 0.3, 1e-3);
  const analysis::CylinderPart c{distance, big, -0.8, upper};
  const double expected = static_cast<double>(cylinder_by_sections(1, c));
  INFO("distance " << distance << " radius " << big << " upper " << upper);
  CHECK(std::abs(sphere_cylinder_volume(1, c) - expected) / sphere_volume(1) < 1e-11);
}

TEST_CASE("boxes that nearly touch a sphere keep their digits") {
  const double touch = GENERATE(as<double>{}, 0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3);
  const double sign = GENERATE(as<double>{}, -1, 1);
  // Face, edge and corner at the surface, and planes through the centre.
  const Vec3 corner =
      GENERATE(Vec3(1, 0.2, -0.3), Vec3(0.6, 0.8, -2), Vec3(1 / std::sqrt(3), 1 / std::sqrt(3), 1 / std::sqrt(3)),
               Vec3(0, 0, 0), Vec3(0, 0, 0.5), Vec3(-0.6, -0.8, 0), Vec3(1, 0, 0));
  const Vec3 min = corner + Vec3::Constant(sign * touch), max = min + Vec3(0.7, 1.1, 3);
  INFO("corner " << min.transpose());
  const double expected = static_cast<double>(box_by_sections(Vec3::Zero(), 1, min, max));
  CHECK(std::abs(sphere_box_volume(Vec3::Zero(), 1, min, max) - expected) / sphere_volume(1) < 1e-14);
}

TEST_CASE("overlap volumes at their limits") {
  const Vec3 centre(0.3, -0.2, 0.1), one = Vec3::Ones();
  CHECK(sphere_box_volume(centre, 0.5, centre - one, centre + one) == Approx(sphere_volume(0.5)).epsilon(1e-15));
  CHECK(sphere_box_volume(centre, 2, centre - one, centre + one) == Approx(8).epsilon(1e-15));
  CHECK(sphere_box_volume(centre, 1, centre, centre + one) == Approx(sphere_volume(1) / 8).epsilon(1e-14));
  CHECK(sphere_box_volume(centre, 1, centre - 5 * one, Vec3(5, 5, centre.z())) ==
        Approx(sphere_volume(1) / 2).epsilon(1e-14));
  CHECK(sphere_box_volume(centre, 0, centre - one, centre + one) == 0);
  CHECK(sphere_box_volume(centre, 1, centre + one, centre - one) == 0);
  CHECK(sphere_box_volume(centre, 1, centre + one, centre + 2 * one) == 0);
  CHECK(analysis::sphere_corner_volume(1, Vec3::Constant(infinity)) == Approx(sphere_volume(1)).epsilon(1e-15));
  CHECK(analysis::sphere_corner_volume(1, {infinity, -1, infinity}) == 0);

  CHECK(sphere_cylinder_volume(0, {0.5, 1, -1, 1}) == 0);
  CHECK(sphere_cylinder_volume(1, {0.5, 0, -1, 1}) == 0);
  CHECK(sphere_cylinder_volume(1, {0.5, 1, 1, -1}) == 0);
  CHECK(sphere_cylinder_volume(1, {0.5, 1, 1, 2}) == 0);
  CHECK(sphere_cylinder_volume(1, {5, 1, -1, 1}) == 0);
  CHECK(sphere_cylinder_volume(1, {2, 3, -infinity, infinity}) == Approx(sphere_volume(1)).epsilon(1e-15));
  CHECK(sphere_cylinder_volume(1, {2, 3, 0, infinity}) == Approx(sphere_volume(1) / 2).epsilon(1e-15));
  // A hole through the centre: sphere less ring, 4 pi / 3 (1 - (1 - R^2)^(3/2)).
  CHECK(sphere_cylinder_volume(1, {0, 0.6, -infinity, infinity}) ==
        Approx(sphere_volume(1) * (1 - 0.512)).epsilon(1e-14));
  // Viviani's body: 2 pi / 3 - 8 / 9.
  CHECK(sphere_cylinder_volume(1, {0.5, 0.5, -infinity, infinity}) ==
        Approx(2 * std::numbers::pi / 3 - 8.0 / 9).epsilon(1e-13));
}

TEST_CASE("the parts of a sphere in a partition add up to it") {
  Random random(3, RandomStream::filling_position, 0);
  for (int k = 0; k < 20; ++k) {
    const double radius = random.uniform(0.1, 2);
    const Vec3 centre(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    double cells = 0, rings = 0;
    for (int x = -6; x < 6; ++x) {
      for (int y = -6; y < 6; ++y) {
        for (int z = -6; z < 6; ++z) {
          const Vec3 low = 0.6 * Vec3(x, y, z);
          cells += sphere_box_volume(centre, radius, low, low + Vec3::Constant(0.6));
        }
      }
    }
    const double distance = std::hypot(centre.x(), centre.y());
    for (int ring = 0; ring < 10; ++ring) {
      for (double lower = -2; lower < 2; lower += 0.5) {
        rings += sphere_cylinder_volume(radius, {distance, 0.4 * (ring + 1), lower, lower + 0.5}) -
                 sphere_cylinder_volume(radius, {distance, 0.4 * ring, lower, lower + 0.5});
      }
    }
    CHECK(cells == Approx(sphere_volume(radius)).epsilon(1e-12));
    CHECK(rings == Approx(sphere_volume(radius)).epsilon(1e-10));
  }
}
