#include "viz/image.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packstone::viz {

namespace {

constexpr int any_factor = 0;

/// One row of sums over factor rows becomes one row of means. A factor known to the compiler is several times faster.
template <int known_factor>
void reduce_row(const std::uint16_t* sums, int width, int factor, std::uint8_t* target) {
  const int side = known_factor == any_factor ? factor : known_factor;
  const int area = side * side;
  for (int column = 0; column < width; ++column, sums += 4 * side, target += 4) {
    for (int channel = 0; channel < 4; ++channel) {
      int sum = area / 2;  // rounds the quotient
      for (int k = 0; k < side; ++k) sum += sums[4 * k + channel];
      target[channel] = static_cast<std::uint8_t>(sum / area);
    }
  }
}

/// Lays one channel of a row, premultiplied, over what is there.
void lay_over(const std::uint32_t* over, int channel, int width, std::uint32_t* tones) {
  constexpr std::uint32_t full = 255;
  for (int k = 0; k < width; ++k) {
    const std::uint32_t left = full - (over[k] >> 24);
    const std::uint32_t sum = (over[k] >> channel & full) + (tones[k] * left + full / 2) / full;
    tones[k] = sum < full ? sum : full;
  }
}

/// Rows of pixels of so many bytes.
void place_rows(std::vector<std::uint8_t>& whole, int width, const std::vector<std::uint8_t>& part, int part_width,
                int rows, int bytes, int left, int top) {
  const std::ptrdiff_t row_bytes = static_cast<std::ptrdiff_t>(part_width) * bytes;
  for (int row = 0; row < rows; ++row) {
    std::copy_n(part.begin() + row * row_bytes, row_bytes,
                whole.begin() + (static_cast<std::ptrdiff_t>(top + row) * width + left) * bytes);
  }
}

}  // namespace

Colour Image::at(int column, int row) const {
  const std::uint8_t* p = &rgb[(static_cast<std::size_t>(row) * width + column) * 3];
  return {p[0], p[1], p[2]};
}

RowAverage::RowAverage(int width, int factor)
    : width_(width), factor_(factor), sums_(static_cast<std::size_t>(width) * 4) {}

void RowAverage::add(const std::uint8_t* rgba, std::uint8_t* target) {
  if (factor_ == 1) {
    std::memcpy(target, rgba, sums_.size());
    return;
  }
  if (rows_ == 0) {
    std::copy_n(rgba, sums_.size(), sums_.begin());
  } else {
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += rgba[i];
  }
  rows_ = (rows_ + 1) % factor_;
  const auto reduce = factor_ == 2 ? reduce_row<2> : reduce_row<any_factor>;
  if (rows_ == 0) reduce(sums_.data(), width_ / factor_, factor_, target);
}

Layer average_down(const std::uint8_t* rgba, int width, int height, int factor) {
  Layer layer{width / factor, height / factor, {}};
  const std::size_t row_bytes = static_cast<std::size_t>(layer.width) * 4;
  layer.rgba.resize(row_bytes * static_cast<std::size_t>(layer.height));
  RowAverage average(width, factor);
  for (int row = 0; row < layer.height * factor; ++row) {
    average.add(rgba + static_cast<std::size_t>(row) * width * 4, &layer.rgba[row_bytes * (row / factor)]);
  }
  return layer;
}

void flatten(const std::vector<const Layer*>& layers, Colour ground, Image& whole, int left, int top) {
  const int width = layers.front()->width, height = layers.front()->height;
  const std::uint8_t tone[3] = {ground.r, ground.g, ground.b};
  std::vector<std::uint32_t> over(width), tones(3 * static_cast<std::size_t>(width));
  for (int row = 0; row < height; ++row) {
    for (int k = 0; k < 3; ++k) std::fill_n(&tones[static_cast<std::size_t>(k) * width], width, tone[k]);
    for (const Layer* layer : layers) {
      std::memcpy(over.data(), &layer->rgba[static_cast<std::size_t>(row) * width * 4], over.size() * 4);
      if (std::all_of(over.begin(), over.end(), [](std::uint32_t pixel) { return pixel == 0; })) continue;
      for (int k = 0; k < 3; ++k) lay_over(over.data(), 8 * k, width, &tones[static_cast<std::size_t>(k) * width]);
    }
    std::uint8_t* pixel = &whole.rgb[(static_cast<std::size_t>(top + row) * whole.width + left) * 3];
    for (int column = 0; column < width; ++column) {
      for (int k = 0; k < 3; ++k)
        *pixel++ = static_cast<std::uint8_t>(tones[static_cast<std::size_t>(k) * width + column]);
    }
  }
}

Image flatten(const std::vector<const Layer*>& layers, Colour ground) {
  Image image{layers.front()->width, layers.front()->height, {}};
  image.rgb.resize(static_cast<std::size_t>(image.width) * image.height * 3);
  flatten(layers, ground, image, 0, 0);
  return image;
}

Layer part_of(const Layer& layer, const PixelWindow& window) {
  Layer part{window.width, window.height, {}};
  part.rgba.reserve(window.pixels() * 4);
  for (int row = window.top; row < window.bottom(); ++row) {
    const auto first = layer.rgba.begin() + (static_cast<std::ptrdiff_t>(row) * layer.width + window.left) * 4;
    part.rgba.insert(part.rgba.end(), first, first + static_cast<std::ptrdiff_t>(window.width) * 4);
  }
  return part;
}

void place(Image& whole, const Image& part, int left, int top) {
  place_rows(whole.rgb, whole.width, part.rgb, part.width, part.height, 3, left, top);
}

void place(Layer& whole, const Layer& part, int left, int top) {
  place_rows(whole.rgba, whole.width, part.rgba, part.width, part.height, 4, left, top);
}

double difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) {
    throw InputError(
        fmt::format("the pictures differ in size: {} x {} and {} x {} px", a.width, a.height, b.width, b.height));
  }
  constexpr int side = 4;
  double total = 0;
  for (int top = 0; top < a.height; top += side) {
    for (int left = 0; left < a.width; left += side) {
      int sums[3] = {0, 0, 0};
      for (int row = top; row < std::min(top + side, a.height); ++row) {
        for (int column = left; column < std::min(left + side, a.width); ++column) {
          const std::size_t first = (static_cast<std::size_t>(row) * a.width + column) * 3;
          for (int k = 0; k < 3; ++k) sums[k] += a.rgb[first + k] - b.rgb[first + k];
        }
      }
      for (const int sum : sums) total += std::abs(sum);
    }
  }
  return total / (3.0 * a.width * a.height);
}

}  // namespace packstone::viz
