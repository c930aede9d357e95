#include "viz/sphere_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/ambient_occlusion.hpp"

namespace packstone::viz {

namespace {

constexpr float infinitely_far = std::numeric_limits<float>::infinity();
constexpr int lanes = 16;  // rows are drawn in so many pixels at a time

// By value: std::min and std::max keep the compiler from vectorising.
inline float lesser(float a, float b) { return a < b ? a : b; }
inline float greater(float a, float b) { return a > b ? a : b; }

/// Lights that go with the viewer: one beside him, the key light over the left shoulder, a weak one from the right; a
/// small highlight from the key light. The normal's components are to the right, down, and away from the viewer.
inline std::uint32_t lit(float diffuse_r, float diffuse_g, float diffuse_b, float nx, float ny, float nz) {
  const float facing = greater(-nz, 0.0F);
  const float key = greater(-0.48F * nx - 0.69F * ny - 0.55F * nz, 0.0F);
  const float fill = greater(0.91F * nx - 0.18F * ny - 0.37F * nz, 0.0F);
  const float light = 0.22F + 0.36F * facing + 0.51F * key + 0.12F * fill;
  float shine = greater(-0.27F * nx - 0.39F * ny - 0.88F * nz, 0.0F);
  for (int k = 0; k < 5; ++k) shine *= shine;
  constexpr float full = 255, opaque = 0xff;
  const float gloss = 0.10F * full * shine + 0.5F;  // rounds
  const auto tone = [&](float diffuse) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(lesser(diffuse * light + gloss, full)));
  };
  return tone(diffuse_r) | tone(diffuse_g) << 8 | tone(diffuse_b) << 16 | static_cast<std::uint32_t>(opaque) << 24;
}

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

/// The farthest distance seen in squares of pixels: what lies behind it all over its box is hidden.
class SphereLayer::Horizon {
 public:
  explicit Horizon(const SphereLayer& layer)
      : layer_(layer),
        columns_((layer.window_.width + side - 1) / side),
        rows_((layer.window_.height + side - 1) / side),
        farthest_(static_cast<std::size_t>(columns_) * rows_, infinitely_far),
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
  static constexpr int side = 8;

  /// Calls visit(square, column, row) until it returns false.
  template <class Visit>
  void for_each_square(const Outline& outline, Visit&& visit) {
    const PixelWindow& window = layer_.window_;
    const int last_row = (outline.below - 1 - window.top) / side, last = (outline.after_right - 1 - window.left) / side;
    for (int row = (outline.top - window.top) / side; row <= last_row; ++row) {
      for (int column = (outline.left - window.left) / side; column <= last; ++column) {
        if (!visit(static_cast<std::size_t>(row) * columns_ + column, column, row)) return;
      }
    }
  }

  void refresh(std::size_t square, int column, int row) {
    const int right = std::min((column + 1) * side, layer_.window_.width);
    const int bottom = std::min((row + 1) * side, layer_.window_.height);
    float farthest = 0;
    for (int y = row * side; y < bottom; ++y) {
      const float* const distance = layer_.distances(y);
      for (int x = column * side; x < right; ++x) farthest = std::max(farthest, distance[x]);
    }
    farthest_[square] = farthest;
    stale_[square] = 0;
  }

  const SphereLayer& layer_;
  int columns_, rows_;
  std::vector<float> farthest_;
  std::vector<std::uint8_t> stale_;
};

SphereLayer::SphereLayer(const Camera& camera)
    : parallel_(camera.parallel()), unit_per_pixel_(static_cast<float>(1 / camera.focal())) {}

void SphereLayer::reset(const PixelWindow& window) {
  window_ = window;
  stride_ = static_cast<std::size_t>(window.width) + lanes;
  offset_ = 0;
  blank_ = true;
}

void SphereLayer::fill() {
  const std::size_t pixels = stride_ * static_cast<std::size_t>(window_.height);
  distance_.assign(pixels, infinitely_far);
  colour_.assign(pixels, 0);
  number_.assign(pixels, nothing);
  blank_ = false;
}

void SphereLayer::draw(const SphereCloud& cloud, bool cull) {
  const auto in_window = [&](const SphereCloud::Packet& packet) { return !clipped(packet.outline, window_).empty(); };
  if (std::none_of(cloud.packets().begin(), cloud.packets().end(), in_window)) return;
  if (blank_) fill();
  Horizon horizon(*this);
  std::vector<SphereCloud::Candidate> found;
  for (const SphereCloud::Packet& packet : cloud.packets()) {
    const Outline outline = clipped(packet.outline, window_);
    if (outline.empty() || (cull && horizon.hides(outline))) continue;
    cloud.find(packet, window_, found);
    for (const SphereCloud::Candidate& candidate : found) {
      if (cull && horizon.hides(candidate.outline)) continue;
      const SeenSphere sphere = cloud.seen(candidate);
      if (parallel_) {
        draw<true>(sphere);
      } else {
        draw<false>(sphere);
      }
      if (cull) horizon.drawn(sphere.outline);
    }
  }
}

// In the camera's axes x to the right, y down, z away from the viewer: the centre is c = distance d0 with
// d0 = (u, v, 1) = (slope_x, slope_y, 1), the ray of a pixel d = d0 + (a, b, 0). The point of the ray nearest to the
// centre is s d,
//   s = distance (d . d0) / d^2,   |c - s d|^2 = distance^2 |d0 x d|^2 / d^2,   d0 x d = (-b, a, u b - v a),
// and the sphere is met g = sqrt((r^2 - |c - s d|^2) / d^2) before it. Nothing large is subtracted from its like, so
// single precision holds for small spheres far away.
template <bool parallel>
void SphereLayer::draw(const SeenSphere& sphere) {
  const float u = sphere.slope_x, v = sphere.slope_y, far = sphere.distance, r = sphere.radius;
  const float along = parallel ? 1.0F : u * u + v * v + 1.0F;
  const float squared_far = parallel ? 1.0F : far * far, squared_radius = r * r, per_radius = 1 / r;
  const float unit = unit_per_pixel_, right = sphere.right;
  const auto diffuse = [&](int place) { return static_cast<float>(sphere.colour >> place & 0xff); };
  const float red = diffuse(0), green = diffuse(8), blue = diffuse(16);
  const std::uint32_t own_number = sphere.number;
  const Outline& outline = sphere.outline;
  const int width = outline.after_right - outline.left, offset = outline.left - sphere.column;
  for (int row = outline.top; row < outline.below; ++row) {
    const std::size_t first = at(row - window_.top) + static_cast<std::size_t>(outline.left - window_.left);
    float* const distance = &distance_[first];
    std::uint32_t* const colour = &colour_[first];
    std::uint32_t* const number = &number_[first];
    const float b = (static_cast<float>(row - sphere.row) - sphere.down) * unit;
    // Whole vectors: beyond the sphere nothing is met, beyond the window is room.
    for (int done = 0; done < width; done += lanes) {
#pragma omp simd
      for (int k = done; k < done + lanes; ++k) {
        const float a = (static_cast<float>(offset + k) - right) * unit;
        const float square = a * a + b * b;
        const float lean = parallel ? 0.0F : a * u + b * v, turn = parallel ? 0.0F : u * b - v * a;
        const float per_length = parallel ? 1.0F : 1 / (along + 2 * lean + square);
        const float inside = squared_radius - squared_far * (square + turn * turn) * per_length;
        const float before = std::sqrt(greater(inside, 0.0F) * per_length);
        const float s = parallel ? far : far * (along + lean) * per_length;
        const float t = s - before;
        const float seen_distance = distance[k];
        const std::uint32_t seen_number = number[k], seen_colour = colour[k];
        const bool first_of_equals = (t == seen_distance) & (own_number < seen_number);
        const bool nearer = (inside > 0) & ((t < seen_distance) | first_of_equals);
        // The point met, from the centre: -g d - (c - s d) with c - s d = shift d0 - s (a, b, 0).
        const float shift = parallel ? 0.0F : far * (lean + square) * per_length;
        const float nx = parallel ? a : s * a - before * (u + a) - shift * u;
        const float ny = parallel ? b : s * b - before * (v + b) - shift * v;
        const float nz = -before - shift;
        const std::uint32_t shade = lit(red, green, blue, nx * per_radius, ny * per_radius, nz * per_radius);
        distance[k] = nearer ? t : seen_distance;
        colour[k] = nearer ? shade : seen_colour;
        number[k] = nearer ? own_number : seen_number;
      }
    }
  }
}

void SphereLayer::merge(const SphereLayer& other) {
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

void SphereLayer::occlude(double strength, double reach, const PixelWindow& inner) {
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
