#include "viz/sphere_cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace packstone::viz {

SphereRows sphere_rows(std::span<const Vec3> centres, std::span<const double> radii, std::span<const Colour> colours) {
  return {.centres = centres, .radii = radii, .colours = RowColours(colours), .chunks = chunks_of(centres, radii)};
}

SphereCloud::SphereCloud(SphereRows rows, const Camera& camera, std::uint32_t first_number)
    : rows_(std::move(rows)), camera_(camera), first_number_(first_number) {
  for (const RowChunk& chunk : rows_.chunks) {
    if (chunk.first == chunk.last || is_cut_away(rows_.cut, chunk.box)) continue;
    chunks_.push_back(
        {chunk.first, chunk.last, outline_of_box(in_space(chunk.box.min), in_space(chunk.box.max), camera)});
  }
  sort_by_distance(chunks_);
}

Outline SphereCloud::outline_of_rows(std::size_t first, std::size_t last) const {
  const Region box = box_of(rows_.centres.subspan(first, last - first), rows_.radii.subspan(first, last - first));
  return outline_of_box(in_space(box.min), in_space(box.max), camera_);
}

std::span<const Packet> SphereCloud::parts_of(const Packet& packet) const {
  const bool is_chunk = &packet >= chunks_.data() && &packet < chunks_.data() + chunks_.size();
  if (!is_chunk) return {};
  const auto [place, is_new] = opened_.try_emplace(packet.first);
  std::vector<Packet>& packets = place->second;
  if (!is_new) return packets;
  if (rows_.before_first_use) {
    const auto ends_before = [](const RowChunk& chunk, std::size_t row) { return chunk.last <= row; };
    rows_.before_first_use(*std::lower_bound(rows_.chunks.begin(), rows_.chunks.end(), packet.first, ends_before));
  }
  for (std::size_t first = packet.first; first < packet.last; first += rows_a_packet) {
    const std::size_t last = std::min(packet.last, first + rows_a_packet);
    packets.push_back({first, last, outline_of_rows(first, last)});
  }
  sort_by_distance(packets);
  return packets;
}

template <bool parallel>
void SphereCloud::find_outlines(const Packet& packet, std::vector<Candidate>& found) const {
  const std::size_t count = packet.last - packet.first;
  std::array<Vec3, rows_a_packet> place;
  std::array<double, rows_a_packet> radius;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = packet.first + k;
    place[k] = camera_.seen_from_eye(in_space(rows_.centres[row]));
    radius[k] = is_left_out(row) ? 0 : rows_.radii[row] * rows_.scale;
  }
  std::array<PixelReach, rows_a_packet> reach;
  const double focal = camera_.focal();
  const Point middle{camera_.centre().x - 0.5, camera_.centre().y - 0.5};
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
  const Vec3 c = centre_seen(candidate);
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
          .radius = static_cast<float>(radius(candidate)),
          .outline = candidate.outline,
          .colour = packed(rows_.colours[candidate.row]),
          .number = static_cast<std::uint32_t>(first_number_ + candidate.row)};
}

}  // namespace packstone::viz
