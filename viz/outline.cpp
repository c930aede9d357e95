#include "viz/outline.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace packstone::viz {

namespace {

constexpr float depth_safety = 1e-5F;  // of the distance, for the rounding of single precision
constexpr double far_out = 1 << 24;    // [px] no picture reaches so far

int whole(double pixel) { return static_cast<int>(std::clamp(pixel, -far_out, far_out)); }

float nearest_of(double distance) { return static_cast<float>(distance) * (1 - depth_safety); }

}  // namespace

Outline clipped(Outline outline, const PixelWindow& window) {
  outline.left = std::max(outline.left, window.left);
  outline.top = std::max(outline.top, window.top);
  outline.after_right = std::min(outline.after_right, window.right());
  outline.below = std::min(outline.below, window.bottom());
  return outline;
}

Outline outline_of_box(const Vec3& low, const Vec3& high, const Camera& camera) {
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
  return outline_of({std::floor(left), std::ceil(right), std::floor(top), std::ceil(bottom)}, near);
}

Outline outline_of(const PixelReach& reach, double distance) {
  return {whole(reach.left), whole(reach.top), whole(reach.right + 1), whole(reach.bottom + 1), nearest_of(distance)};
}

void sort_by_distance(std::vector<Packet>& packets) {
  std::sort(packets.begin(), packets.end(), [](const Packet& a, const Packet& b) {
    return std::pair(a.outline.nearest, a.first) < std::pair(b.outline.nearest, b.first);
  });
}

void keep_visible(std::vector<Candidate>& candidates, const PixelWindow& window) {
  // Distances are not negative, so their bits have their order; equal ones follow the rows, which ascend.
  std::array<std::uint64_t, rows_a_packet> order;
  std::array<Candidate, rows_a_packet> kept;
  std::size_t count = 0;
  for (Candidate& candidate : candidates) {
    candidate.outline = clipped(candidate.outline, window);
    if (candidate.outline.empty()) continue;
    order[count] = std::uint64_t{std::bit_cast<std::uint32_t>(candidate.outline.nearest)} << 32 | count;
    kept[count++] = candidate;
  }
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  candidates.resize(count);
  for (std::size_t k = 0; k < count; ++k) candidates[k] = kept[order[k] & 0xffffffff];
}

}  // namespace packstone::viz
