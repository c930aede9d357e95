// Pictures in memory: averaging down, laying one over the other, and a score of how alike two are.
#pragma once

#include <cstdint>
#include <vector>

#include "viz/pixel_window.hpp"
#include "viz/style.hpp"

namespace packstone::viz {

/// An opaque picture.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< (height * width * 3), top row first

  /// Column from the left, row from the top, both within the picture.
  Colour at(int column, int row) const;
};

/// A picture with transparent parts.
struct Layer {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< (height * width * 4), top row first, colours premultiplied by alpha
};

/// Averages squares of factor x factor pixels of a picture (height * width * 4), whose sides are multiples of factor.
/// This is all the smoothing there is, so that tiles of a picture merge byte for byte.
Layer average_down(const std::uint8_t* rgba, int width, int height, int factor);

/// The same row by row.
class RowAverage {
 public:
  /// width: of the rows of samples, a multiple of factor.
  RowAverage(int width, int factor);
  /// Takes a row of samples (width * 4); the last of factor rows writes a row of pixels (width / factor * 4) to target.
  void add(const std::uint8_t* rgba, std::uint8_t* target);

 private:
  int width_, factor_, rows_ = 0;
  std::vector<std::uint16_t> sums_;
};

/// Lays the layers over a plain ground, the first lowest. All have the same size.
Image flatten(const std::vector<const Layer*>& layers, Colour ground);
/// The same into its place in a picture.
void flatten(const std::vector<const Layer*>& layers, Colour ground, Image& whole, int left, int top);

/// A part of a layer.
Layer part_of(const Layer& layer, const PixelWindow& window);

/// Puts a part in its place in a picture.
void place(Image& whole, const Image& part, int left, int top);
void place(Layer& whole, const Layer& part, int left, int top);

/// Mean absolute difference of two pictures over all pixels and channels after each was averaged over 4 x 4 squares:
/// 0 for the same picture, 255 for white against black. The squares forgive what renderers do differently at edges, not
/// a wrong colour or a moved object: a thing that covers the share s of the picture and is off by d adds s * d. Throws
/// InputError when the sizes differ.
double difference(const Image& a, const Image& b);

}  // namespace packstone::viz
