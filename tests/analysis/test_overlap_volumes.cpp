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
constexpr Real pi = std::numbers::pi_v<Real>;
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
  if (d <= std::abs(a - b)) return pi * std::min(a, b) * std::min(a, b);
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
  double worst = 0;
  for (int k = 0; k < 3000; ++k) {
    const double radius = std::exp2(random.uniform(-5, 2));
    const double big = std::exp2(random.uniform(-2, 2));
    const double distance = std::max(0.0, big + radius * random.uniform(-1, 1));
    const bool whole = k % 2;
    const double lower = whole ? -infinity : radius * random.uniform(-1.1, 0.9);
    const double upper = whole ? infinity : lower + radius * random.uniform(0.01, 2);
    const analysis::CylinderPart c{distance, big, lower, upper};
    const double expected = static_cast<double>(cylinder_by_sections(radius, c));
    const double error = std::abs(sphere_cylinder_volume(radius, c) - expected) / sphere_volume(radius);
    if (error > worst) {
      worst = error;
      WARN("r " << radius << " d " << distance << " R " << big << " " << lower << " " << upper << " error " << error);
    }
  }
  CHECK(worst < 1e-11);
}
