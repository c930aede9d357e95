// What cannot be seen any more, because all of its place is taken by nearer things.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "viz/outline.hpp"
#include "viz/pixel_layer.hpp"

namespace packstone::viz {

/// The farthest distance seen in squares of pixels of a layer: what lies behind it all over its box is hidden.
class Horizon {
 public:
  explicit Horizon(const PixelLayer& layer)
      : layer_(layer),
        columns_((layer.window().width + side - 1) / side),
        rows_((layer.window().height + side - 1) / side),
        farthest_(static_cast<std::size_t>(columns_) * rows_, std::numeric_limits<float>::infinity()),
        stale_(farthest_.size(), 1) {}

  bool hides(const Outline& outline) {
    bool hidden = true;
    for_each_square(outline, [&](std::size_t square, int column, int row) {
      if (stale_[square] != 0) refresh(square, column, row);
      hidden = farthest_[square] < outline.nearest;
      return hidden;
    });
    return hidden;
  }

  void drawn(const Outline& outline) {
    for_each_square(outline, [&](std::size_t square, int, int) {
      stale_[square] = 1;
      return true;
    });
  }

 private:
  static constexpr int side = 4;

  /// Calls visit(square, column, row) until it returns false.
  template <class Visit>
  void for_each_square(const Outline& outline, Visit&& visit) {
    const PixelWindow& window = layer_.window();
    const int last_row = (outline.below - 1 - window.top) / side, last = (outline.after_right - 1 - window.left) / side;
    for (int row = (outline.top - window.top) / side; row <= last_row; ++row) {
      for (int column = (outline.left - window.left) / side; column <= last; ++column) {
        if (!visit(static_cast<std::size_t>(row) * columns_ + column, column, row)) return;
      }
    }
  }

  void refresh(std::size_t square, int column, int row) {
    const int right = std::min((column + 1) * side, layer_.window().width);
    const int bottom = std::min((row + 1) * side, layer_.window().height);
    std::array<float, side> farthest{};  // of the columns
    for (int y = row * side; y < bottom; ++y) {
      const float* const distance = layer_.distances(y) + column * side;
      if (right == (column + 1) * side) {
        for (int k = 0; k < side; ++k) farthest[k] = distance[k] > farthest[k] ? distance[k] : farthest[k];
      } else {
        for (int k = 0; k < right - column * side; ++k) farthest[k] = std::max(farthest[k], distance[k]);
      }
    }
    farthest_[square] = *std::max_element(farthest.begin(), farthest.end());
    stale_[square] = 0;
  }

  const PixelLayer& layer_;
  int columns_, rows_;
  std::vector<float> farthest_;
  std::vector<std::uint8_t> stale_;
};

/// Draws the bodies of a cloud that can be seen over what is in the layer: draw_one(candidate). With cull those that
/// others hide cost little; the pixels are the same.
template <class Cloud, class DrawOne>
void draw_visible(PixelLayer& layer, const Cloud& cloud, bool cull, DrawOne&& draw_one) {
  const auto farther = [](const Packet* a, const Packet* b) {
    return std::pair(a->outline.nearest, a->first) > std::pair(b->outline.nearest, b->first);
  };
  std::priority_queue<const Packet*, std::vector<const Packet*>, decltype(farther)> nearest(farther);
  const auto add = [&](std::span<const Packet> packets) {
    for (const Packet& packet : packets) {
      if (!clipped(packet.outline, layer.window()).empty()) nearest.push(&packet);
    }
  };
  add(cloud.packets());
  if (nearest.empty()) return;
  layer.make_drawable();
  Horizon horizon(layer);
  std::vector<Candidate> found;
  while (!nearest.empty()) {
    const Packet& packet = *nearest.top();
    nearest.pop();
    if (cull && horizon.hides(clipped(packet.outline, layer.window()))) continue;
    const std::span<const Packet> parts = cloud.parts_of(packet);
    if (!parts.empty()) {
      add(parts);
      continue;
    }
    cloud.find(packet, layer.window(), found);
    for (const Candidate& candidate : found) {
      if (cull && horizon.hides(candidate.outline)) continue;
      draw_one(candidate);
      if (cull) horizon.drawn(candidate.outline);
    }
  }
}

}  // namespace packstone::viz
