#include "viz/sphere_cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace packstone::viz {

namespace {

/// Of the box about a number of spheres.
Outline outline_of(std::span<const Vec3> centres, std::span<const double> radii, const Camera& camera) {
  Vec3 low = centres.front(), high = low;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    low = low.cwiseMin((centres[i].array() - radii[i]).matrix());
    high = high.cwiseMax((centres[i].array() + radii[i]).matrix());
  }
  return outline_of_box(low, high, camera);
}

}  // namespace

SphereCloud::SphereCloud(std::span<const Vec3> centres, std::span<const double> radii, std::span<const Colour> colours,
                         const Camera& camera, std::uint32_t first_number)
    : centres_(centres), radii_(radii), colours_(colours), camera_(camera), first_number_(first_number) {
  for (std::size_t first = 0; first < centres.size(); first += rows_a_packet) {
    const std::size_t rows = std::min(rows_a_packet, centres.size() - first);
    const Outline outline = outline_of(centres.subspan(first, rows), radii.subspan(first, rows), camera);
    packets_.push_back({first, first + rows, outline});
  }
  sort_by_distance(packets_);
}

template <bool parallel>
void SphereCloud::find_outlines(const Packet& packet, std::vector<Candidate>& found) const {
  const std::size_t count = packet.last - packet.first;
  std::array<Vec3, rows_a_packet> place;
  for (std::size_t k = 0; k < count; ++k) place[k] = camera_.seen_from_eye(centres_[packet.first + k]);
  std::array<PixelReach, rows_a_packet> reach;
  const double focal = camera_.focal();
  const Point middle{camera_.centre().x - 0.5, camera_.centre().y - 0.5};
  const double* const radius = &radii_[packet.first];
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k) {
    reach[k] = reach_of_sphere<parallel>(place[k].x(), place[k].y(), place[k].z(), radius[k], focal, middle);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double nearest = place[k].z() - radius[k];
    if (!(radius[k] > 0) || nearest < camera_.nearest_distance()) continue;
    found.push_back({outline_of(reach[k], nearest), packet.first + k});
  }
}

void SphereCloud::find(const Packet& packet, const PixelWindow& window, std::vector<Candidate>& found) const {
  found.clear();
  if (camera_.parallel()) {
    find_outlines<true>(packet, found);
  } else {
    find_outlines<false>(packet, found);
  }
  keep_visible(found, window);
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
