#include "viz/sphere_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace packstone::viz {

namespace {

constexpr std::size_t rows_a_packet = 64;
constexpr double edge_safety = 0.01;   // [px] for the rounding of single precision
constexpr float depth_safety = 1e-5F;  // of the distance, likewise
constexpr double far_out = 1 << 24;    // [px] no picture reaches so far

int whole(double pixel) { return static_cast<int>(std::clamp(pixel, -far_out, far_out)); }

float nearest_of(double distance) { return static_cast<float>(distance) * (1 - depth_safety); }

std::uint32_t packed(Colour c) {
  return static_cast<std::uint32_t>(c.r) | static_cast<std::uint32_t>(c.g) << 8 | static_cast<std::uint32_t>(c.b) << 16;
}

/// Of the box about a number of spheres.
Outline outline_of(std::span<const Vec3> centres, std::span<const double> radii, const Camera& camera) {
  Vec3 low = centres.front(), high = low;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    low = low.cwiseMin((centres[i].array() - radii[i]).matrix());
    high = high.cwiseMax((centres[i].array() + radii[i]).matrix());
  }
  double left = std::numeric_limits<double>::infinity(), right = -left, top = left, bottom = -left, near = left;
  for (const Vec3& corner : box_corners(low, high)) {
    near = std::min(near, camera.seen_from_eye(corner).z());
    const Point p = camera.project(corner);
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  // Beside or behind the viewer corners project anywhere.
  if (near < camera.nearest_distance()) return {whole(-far_out), whole(-far_out), whole(far_out), whole(far_out), 0};
  return {whole(std::floor(left)), whole(std::floor(top)), whole(std::ceil(right) + 1), whole(std::ceil(bottom) + 1),
          nearest_of(near)};
}

/// Lowest and highest coordinate or slope of a sphere along one side of the picture.
struct Extent {
  double low, high;
};

/// Slopes of the two tangents from the viewer to a circle with its centre so far across and along the line of sight.
Extent tangents(double across, double along, double radius) {
  const double square = along * along - radius * radius;
  const double root = radius * std::sqrt(across * across + square);
  return {(across * along - root) / square, (across * along + root) / square};
}

/// The pixels whose middles a sphere with its centre at c, as seen from the eye, can cover.
Outline outline_of(const Vec3& c, double radius, const Camera& camera) {
  Extent x{c.x() - radius, c.x() + radius}, y{c.y() - radius, c.y() + radius};
  if (!camera.parallel()) {
    x = tangents(c.x(), c.z(), radius);
    y = tangents(c.y(), c.z(), radius);
  }
  const auto pixel = [&](double middle, double place) { return middle + camera.focal() * place - 0.5; };
  const Point middle = camera.centre();
  return {whole(std::ceil(pixel(middle.x, x.low) - edge_safety)),
          whole(std::ceil(pixel(middle.y, y.low) - edge_safety)),
          whole(std::floor(pixel(middle.x, x.high) + edge_safety) + 1),
          whole(std::floor(pixel(middle.y, y.high) + edge_safety) + 1), nearest_of(c.z() - radius)};
}

}  // namespace

Outline clipped(Outline outline, const PixelWindow& window) {
  outline.left = std::max(outline.left, window.left);
  outline.top = std::max(outline.top, window.top);
  outline.after_right = std::min(outline.after_right, window.right());
  outline.below = std::min(outline.below, window.bottom());
  return outline;
}

SphereCloud::SphereCloud(std::span<const Vec3> centres, std::span<const double> radii, std::span<const Colour> colours,
                         const Camera& camera, std::uint32_t first_number)
    : centres_(centres), radii_(radii), colours_(colours), camera_(camera), first_number_(first_number) {
  for (std::size_t first = 0; first < centres.size(); first += rows_a_packet) {
    const std::size_t rows = std::min(rows_a_packet, centres.size() - first);
    const Outline outline = outline_of(centres.subspan(first, rows), radii.subspan(first, rows), camera);
    packets_.push_back({first, first + rows, outline});
  }
  std::sort(packets_.begin(), packets_.end(), [](const Packet& a, const Packet& b) {
    return std::pair(a.outline.nearest, a.first) < std::pair(b.outline.nearest, b.first);
  });
}

void SphereCloud::see(const Packet& packet, const PixelWindow& window, std::vector<SeenSphere>& seen) const {
  seen.clear();
  const bool parallel = camera_.parallel();
  for (std::size_t i = packet.first; i < packet.last; ++i) {
    const Vec3 c = camera_.seen_from_eye(centres_[i]);
    if (!(radii_[i] > 0) || c.z() - radii_[i] < camera_.nearest_distance()) continue;
    const Outline outline = clipped(outline_of(c, radii_[i], camera_), window);
    if (outline.empty()) continue;
    const double slope_x = parallel ? 0 : c.x() / c.z(), slope_y = parallel ? 0 : c.y() / c.z();
    const double x = camera_.centre().x + camera_.focal() * (parallel ? c.x() : slope_x) - 0.5;
    const double y = camera_.centre().y + camera_.focal() * (parallel ? c.y() : slope_y) - 0.5;
    const double column = std::round(x), row = std::round(y);
    seen.push_back({.column = static_cast<int>(column),
                    .row = static_cast<int>(row),
                    .right = static_cast<float>(x - column),
                    .down = static_cast<float>(y - row),
                    .slope_x = static_cast<float>(slope_x),
                    .slope_y = static_cast<float>(slope_y),
                    .distance = static_cast<float>(c.z()),
                    .radius = static_cast<float>(radii_[i]),
                    .outline = outline,
                    .colour = packed(colours_[i]),
                    .number = static_cast<std::uint32_t>(first_number_ + i)});
  }
  std::sort(seen.begin(), seen.end(), [](const SeenSphere& a, const SeenSphere& b) {
    return std::pair(a.outline.nearest, a.number) < std::pair(b.outline.nearest, b.number);
  });
}

}  // namespace packstone::viz
