#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/packing/overlap_volume.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

using std::numbers::pi;
constexpr int rule_points = 16;
constexpr double rule_rounding = 1e-15;  // of a zero of Legendre's polynomial
constexpr double wide_layer = 0.5;       // angle; a steeper change at the arc's end takes panels of its own
constexpr double finest_panel = 1e-5;    // angle; the integrand falls with its square to the end
constexpr double panel_ratio = 4;
constexpr std::size_t most_panels = 64;

struct Rule {
  std::array<double, rule_points> point, weight;  // on [0, 1]
};

/// Gauss and Legendre's, by Newton's steps from Tricomi's guesses.
Rule gauss_legendre() {
  Rule rule;
  for (int i = 0; i < rule_points; ++i) {
    double x = std::cos(pi * (i + 0.75) / (rule_points + 0.5)), slope = 0, step = 1;
    while (std::abs(step) > rule_rounding) {
      const double value = std::legendre(rule_points, x);
      slope = rule_points * (x * value - std::legendre(rule_points - 1, x)) / (x * x - 1);
      step = value / slope;
      x -= step;
    }
    rule.point[i] = (1 - x) / 2;
    rule.weight[i] = 1 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

/// x - sin x without cancellation.
double minus_sine(double x) {
  constexpr double series_end = 0.7;
  if (x > series_end) return x - std::sin(x);
  double term = x * x * x / 6, sum = 0;
  for (int k = 4; std::abs(term) > 1e-17 * std::abs(sum); k += 2) {
    sum += term;
    term *= -x * x / (k * (k + 1));
  }
  return sum;
}

double square(double x) { return x * x; }

/// x + y - z to the last digit (Kahan's order of the sides of a triangle).
double excess(double x, double y, double z) { return (std::max(x, y) - z) + std::min(x, y); }

/// The sphere between its equator and a plane at a signed height: within a distance s of the vertical through its
/// centre it holds 2 pi s^2 share(s), below the equator counted negative.
class Half {
 public:
  Half(double radius, double height)
      : sign_(height < 0 ? -1 : 1),
        height_(std::min(std::abs(height), radius)),
        flat_(radius * radius - height_ * height_),
        at_rim_(height_ / 2 - height_ * height_ * height_ / (6 * radius * radius)) {}

  double height() const { return height_; }
  /// share at s = r.
  double at_rim() const { return sign_ * at_rim_; }
  /// share less that at s = r; s2 = s^2, w = sqrt(r^2 - s^2).
  double above_rim(double s2, double w) const {
    if (w >= height_) return sign_ * (height_ / 2 - at_rim_);
    const double flat = flat_ / s2;
    const double cubic = (height_ * height_ + height_ * w + w * w) / (3 * (height_ + w));
    return sign_ * (height_ * flat / 2 + (1 - flat) * cubic - at_rim_);
  }

 private:
  double sign_;
  double height_;
  double flat_;  // where the plane cuts the sphere, s^2
  double at_rim_;
};

/// The part of the cylinder's circle inside the sphere's, from the middle to one end.
class Arc {
 public:
  Arc(double radius, const CylinderPart& c)
      : near_(c.radius - c.distance),
        product_(4 * c.radius * c.distance),
        distance_(c.distance),
        upper_(radius, c.upper),
        lower_(radius, c.lower) {
    const double reach = excess(radius, c.distance, c.radius) * excess(radius, c.radius, c.distance);
    const double rest = excess(c.radius, c.distance, radius) * (c.radius + c.distance + radius);
    k2_ = std::clamp(reach / product_, 0.0, 1.0);
    complement_ = std::clamp(rest / product_, 0.0, 1.0);
    least_w2_ = std::max(0.0, -rest);
    half_angle_ = std::atan2(std::sqrt(k2_), std::sqrt(complement_));
    cut_ = upper_.height() < radius || lower_.height() < radius;
  }

  /// beta at the end.
  double angle() const { return 2 * half_angle_; }

  /// Integral of (R - d cos beta) (share - share at the rim) over beta.
  double integral() const {
    static const Rule rule = gauss_legendre();
    std::array<double, most_panels> end;
    const std::size_t panels = panel_ends(end);
    double sum = 0, from = 0;
    for (std::size_t p = 0; p < panels; ++p) {
      const double width = end[p] - from;
      for (int i = 0; i < rule_points; ++i) sum += width * rule.weight[i] * integrand(from + width * rule.point[i]);
      from = end[p];
    }
    return sum;
  }

 private:
  double integrand(double theta) const {
    const double sine2 = square(std::sin(theta)), cosine = std::cos(theta), cosine2 = square(cosine);
    const double s2 = near_ * near_ + product_ * k2_ * sine2;
    const double w = std::sqrt(least_w2_ + product_ * k2_ * cosine2);
    const double jacobian = 2 * std::sqrt(k2_) * cosine / std::sqrt(complement_ + k2_ * cosine2);
    return (near_ + 2 * distance_ * k2_ * sine2) * (upper_.above_rim(s2, w) - lower_.above_rim(s2, w)) * jacobian;
  }

  /// Ends of the panels of [0, pi / 2]: one as a rule; more towards the arc's end where the circles nearly touch there
  /// from within, and from where a plane leaves the sphere.
  std::size_t panel_ends(std::array<double, most_panels>& end) const {
    constexpr double last = pi / 2;
    std::size_t count = 0;
    const auto add = [&](double theta) {
      if (theta > 0 && theta < last && count + 1 < most_panels) end[count++] = theta;
    };
    const double layer = std::sqrt(std::max(complement_, least_w2_ / product_) / k2_);
    for (double rest = last / panel_ratio; layer < wide_layer && rest > std::max(layer / 2, finest_panel);
         rest /= panel_ratio) {
      add(last - rest);
    }
    for (const Half* half : {&upper_, &lower_}) {
      const double cosine2 = (square(half->height()) - least_w2_) / (product_ * k2_);
      if (!cut_ || !(cosine2 >= 0) || !(cosine2 < 1)) continue;
      const double leaves = std::acos(std::sqrt(cosine2));
      for (double theta = std::max(leaves, finest_panel); theta < last; theta *= 2) add(theta);
    }
    std::sort(end.begin(), end.begin() + static_cast<std::ptrdiff_t>(count));
    end[count++] = last;
    return count;
  }

  double near_;     // R - d
  double product_;  // 4 R d
  double distance_;
  Half upper_, lower_;
  double k2_, complement_;  // sin^2 and cos^2 of half of beta at the end
  double least_w2_;         // w^2 there
  double half_angle_;
  bool cut_;
};

/// Half of the angle of the sphere's circle that lies inside the cylinder's.
double sphere_arc(double radius, const CylinderPart& c) {
  const double sine2 = excess(c.radius, c.distance, radius) * excess(c.radius, radius, c.distance);
  const double cosine2 = excess(radius, c.distance, c.radius) * (radius + c.distance + c.radius);
  return 2 * std::atan2(std::sqrt(std::max(0.0, sine2)), std::sqrt(std::max(0.0, cosine2)));
}

}  // namespace

double sphere_cylinder_volume(double radius, const CylinderPart& cylinder) {
  const double d = cylinder.distance, R = cylinder.radius;
  if (!(radius > 0) || !(R > 0) || !(cylinder.upper > cylinder.lower) || d - R >= radius) return 0;
  const double slab = sphere_slab_volume(radius, 0, cylinder.lower, cylinder.upper);
  if (slab <= 0 || d + radius <= R) return slab;
  CylinderPart part = cylinder;
  // About the sphere's own centre line the arc has no middle; so near to it the volume is the same to rounding.
  part.distance = std::max(d, 1e-14 * R);
  const Arc arc(radius, part);
  const double beta = arc.angle();
  const double flux = R * ((R - part.distance) * beta + part.distance * minus_sine(beta)) / (radius * radius);
  const double volume = slab * (sphere_arc(radius, part) + flux) / pi + 2 * R * arc.integral();
  return std::clamp(volume, 0.0, slab);
}

}  // namespace packstone::analysis
