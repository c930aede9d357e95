#include "viz/pixel_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/ambient_occlusion.hpp"

namespace packstone::viz {

namespace {

constexpr float infinitely_far = std::numeric_limits<float>::infinity();

/// Multiplies the colours of a row.
void darken(std::uint32_t* colours, const float* light, int width) {
  for (int k = 0; k < width; ++k) {
    const std::uint32_t colour = colours[k];
    const auto tone = [&](int place) {
      const auto full = static_cast<std::int32_t>(colour >> place & 0xff);
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(static_cast<float>(full) * light[k] + 0.5F)) << place;
    };
    colours[k] = tone(0) | tone(8) | tone(16) | (colour & 0xff000000);
  }
}

}  // namespace

PixelLayer::PixelLayer(const Camera& camera)
    : parallel_(camera.parallel()), unit_per_pixel_(static_cast<float>(1 / camera.focal())) {}

void PixelLayer::reset(const PixelWindow& window) {
  window_ = window;
  stride_ = static_cast<std::size_t>(window.width) + room;
  offset_ = 0;
  blank_ = true;
}

void PixelLayer::fill() {
  const std::size_t pixels = stride_ * static_cast<std::size_t>(window_.height);
  distance_.assign(pixels, infinitely_far);
  colour_.assign(pixels, 0);
  number_.assign(pixels, nothing);
  blank_ = false;
}

void PixelLayer::merge(const PixelLayer& other) {
  if (other.blank_) return;
  if (blank_) {
    *this = other;
    return;
  }
  for (std::size_t k = 0; k < distance_.size(); ++k) {
    const bool nearer =
        other.distance_[k] < distance_[k] || (other.distance_[k] == distance_[k] && other.number_[k] < number_[k]);
    if (!nearer) continue;
    distance_[k] = other.distance_[k];
    colour_[k] = other.colour_[k];
    number_[k] = other.number_[k];
  }
}

void PixelLayer::occlude(double strength, double reach, const PixelWindow& inner) {
  if (!blank_) {
    const std::size_t skipped = at(inner.top - window_.top) + static_cast<std::size_t>(inner.left - window_.left);
    const HollowProbe probe(reach, unit_per_pixel_, parallel_, stride_);
    const std::vector<float> nearness = nearness_of(distance_, parallel_);
    std::vector<float> light(static_cast<std::size_t>(inner.width));
    for (int row = 0; row < inner.height; ++row) {
      const std::size_t first = skipped + static_cast<std::size_t>(row) * stride_;
      probe.light(&nearness[first], inner.width, static_cast<float>(strength), light.data());
      darken(&colour_[first], light.data(), inner.width);
    }
    offset_ = skipped;
  }
  window_ = inner;
}

}  // namespace packstone::viz
