#include "viz/frustum_cloud.hpp"

#include <algorithm>

namespace packstone::viz {

FrustumCloud::FrustumCloud(std::span<const Frustum> frusta, const Camera& camera, std::uint32_t first_number)
    : frusta_(frusta), camera_(camera), first_number_(first_number) {
  for (std::size_t first = 0; first < frusta.size(); first += rows_a_packet) {
    const std::size_t last = std::min(frusta.size(), first + rows_a_packet);
    Vec3 low = frusta[first].from, high = low;
    for (std::size_t k = first; k < last; ++k) {
      const Frustum& f = frusta[k];
      const double reach = std::max(f.from_radius, f.to_radius);
      low = low.cwiseMin((f.from.cwiseMin(f.to).array() - reach).matrix());
      high = high.cwiseMax((f.from.cwiseMax(f.to).array() + reach).matrix());
    }
    packets_.push_back({first, last, outline_of_box(low, high, camera)});
  }
  sort_by_distance(packets_);
}

PixelReach FrustumCloud::reach_of_end(const Vec3& end, double radius) const {
  const Point middle{camera_.centre().x - 0.5, camera_.centre().y - 0.5};
  return camera_.parallel() ? reach_of_sphere<true>(end.x(), end.y(), end.z(), radius, camera_.focal(), middle)
                            : reach_of_sphere<false>(end.x(), end.y(), end.z(), radius, camera_.focal(), middle);
}

// A frustum lies within the hull of the spheres about its ends.
void FrustumCloud::find(const Packet& packet, const PixelWindow& window, std::vector<Candidate>& found) const {
  found.clear();
  for (std::size_t row = packet.first; row < packet.last; ++row) {
    const Frustum& f = frusta_[row];
    if (f.from == f.to) continue;
    const Vec3 from = camera_.seen_from_eye(f.from), to = camera_.seen_from_eye(f.to);
    const double nearest = std::min(from.z() - f.from_radius, to.z() - f.to_radius);
    if (nearest < camera_.nearest_distance()) continue;
    const PixelReach a = reach_of_end(from, f.from_radius), b = reach_of_end(to, f.to_radius);
    const PixelReach both{std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.top, b.top),
                          std::max(a.bottom, b.bottom)};
    found.push_back({outline_of(both, nearest), row});
  }
  keep_visible(found, window);
}

SeenFrustum FrustumCloud::seen(const Candidate& candidate) const {
  const Frustum& f = frusta_[candidate.row];
  const Vec3 from = camera_.seen_from_eye(f.from), to = camera_.seen_from_eye(f.to);
  const PixelReach a = reach_of_end(from, f.from_radius), b = reach_of_end(to, f.to_radius);
  constexpr double rounding = 1;  // [px] the reaches are in whole pixels
  const auto middle = [](const PixelReach& r) { return Point{(r.left + r.right) / 2, (r.top + r.bottom) / 2}; };
  return {.from = from,
          .axis = (to - from).normalized(),
          .length = (to - from).norm(),
          .from_radius = f.from_radius,
          .to_radius = f.to_radius,
          .outline = candidate.outline,
          .colour = packed(f.colour),
          .number = static_cast<std::uint32_t>(first_number_ + candidate.row),
          .ends = {middle(a), middle(b)},
          .half_width = std::max(a.right - a.left, b.right - b.left) / 2 + rounding,
          .half_height = std::max(a.bottom - a.top, b.bottom - b.top) / 2 + rounding};
}

}  // namespace packstone::viz
