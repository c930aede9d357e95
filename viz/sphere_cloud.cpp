#include "viz/sphere_cloud.hpp"

#include <algorithm>
#include <array>
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

// A sphere's picture ends, along either side, at the tangents from the viewer: with its centre so far across and along
// the line of sight these have the slopes (across along -+ r sqrt(across^2 + along^2 - r^2)) / (along^2 - r^2). It
// covers the pixels whose middles lie between.
template <bool parallel>
void SphereCloud::find_outlines(const Packet& packet, std::vector<Candidate>& found) const {
  const std::size_t count = packet.last - packet.first;
  std::array<Vec3, rows_a_packet> place;
  for (std::size_t k = 0; k < count; ++k) place[k] = camera_.seen_from_eye(centres_[packet.first + k]);
  std::array<double, rows_a_packet> left, top, right, bottom;
  const double focal = camera_.focal(), middle_x = camera_.centre().x - 0.5, middle_y = camera_.centre().y - 0.5;
  const double* const radius = &radii_[packet.first];
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k) {
    const double x = place[k].x(), y = place[k].y(), z = place[k].z(), r = radius[k];
    const double square = parallel ? 1 : z * z - r * r, along = parallel ? 1 : z;
    const double reach_x = parallel ? r : r * std::sqrt(x * x + square);
    const double reach_y = parallel ? r : r * std::sqrt(y * y + square);
    const double scale = focal / square;
    left[k] = std::ceil(middle_x + (x * along - reach_x) * scale - edge_safety);
    right[k] = std::floor(middle_x + (x * along + reach_x) * scale + edge_safety);
    top[k] = std::ceil(middle_y + (y * along - reach_y) * scale - edge_safety);
    bottom[k] = std::floor(middle_y + (y * along + reach_y) * scale + edge_safety);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double nearest = place[k].z() - radius[k];
    if (!(radius[k] > 0) || nearest < camera_.nearest_distance()) continue;
    found.push_back({{whole(left[k]), whole(top[k]), whole(right[k] + 1), whole(bottom[k] + 1), nearest_of(nearest)},
                     packet.first + k});
  }
}

void SphereCloud::find(const Packet& packet, const PixelWindow& window, std::vector<Candidate>& found) const {
  found.clear();
  if (camera_.parallel()) {
    find_outlines<true>(packet, found);
  } else {
    find_outlines<false>(packet, found);
  }
  const auto end = std::remove_if(found.begin(), found.end(), [&](Candidate& candidate) {
    candidate.outline = clipped(candidate.outline, window);
    return candidate.outline.empty();
  });
  found.erase(end, found.end());
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.outline.nearest < b.outline.nearest || (a.outline.nearest == b.outline.nearest && a.row < b.row);
  });
}

SeenSphere SphereCloud::seen(const Candidate& candidate) const {
  const Vec3 c = camera_.seen_from_eye(centres_[candidate.row]);
  const bool parallel = camera_.parallel();
  const double slope_x = parallel ? 0 : c.x() / c.z(), slope_y = parallel ? 0 : c.y() / c.z();
  const double x = camera_.centre().x + camera_.focal() * (parallel ? c.x() : slope_x) - 0.5;
  const double y = camera_.centre().y + camera_.focal() * (parallel ? c.y() : slope_y) - 0.5;
  const double column = std::round(x), row = std::round(y);
  return {.column = static_cast<int>(column),
          .row = static_cast<int>(row),
          .right = static_cast<float>(x - column),
          .down = static_cast<float>(y - row),
          .slope_x = static_cast<float>(slope_x),
          .slope_y = static_cast<float>(slope_y),
          .distance = static_cast<float>(c.z()),
          .radius = static_cast<float>(radii_[candidate.row]),
          .outline = candidate.outline,
          .colour = packed(colours_[candidate.row]),
          .number = static_cast<std::uint32_t>(first_number_ + candidate.row)};
}

}  // namespace packstone::viz
