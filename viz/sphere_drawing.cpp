#include "viz/sphere_drawing.hpp"

#include <cmath>
#include <cstdint>

#include "viz/horizon.hpp"
#include "viz/lighting.hpp"

namespace packstone::viz {

namespace {

// Rows are drawn in so many pixels at a time; those of small spheres in fewer.
constexpr int wide = PixelLayer::room, narrow = wide / 2;

// In the camera's axes x to the right, y down, z away from the viewer: the centre is c = distance d0 with
// d0 = (u, v, 1) = (slope_x, slope_y, 1), the ray of a pixel d = d0 + (a, b, 0). The point of the ray nearest to the
// centre is s d,
//   s = distance (d . d0) / d^2,   |c - s d|^2 = distance^2 |d0 x d|^2 / d^2,   d0 x d = (-b, a, u b - v a),
// and the sphere is met g = sqrt((r^2 - |c - s d|^2) / d^2) before it. Nothing large is subtracted from its like, so
// single precision holds for small spheres far away.
template <bool parallel, int lanes>
void draw_sphere(PixelLayer& layer, const SeenSphere& sphere, float unit) {
  const float u = sphere.slope_x, v = sphere.slope_y, far = sphere.distance, r = sphere.radius;
  const float along = parallel ? 1.0F : u * u + v * v + 1.0F;
  const float squared_far = parallel ? 1.0F : far * far, squared_radius = r * r, per_radius = 1 / r;
  const float right = sphere.right;
  const auto diffuse = [&](int place) { return static_cast<float>(sphere.colour >> place & 0xff); };
  const float red = diffuse(0), green = diffuse(8), blue = diffuse(16);
  const std::uint32_t own_number = sphere.number;
  const Outline& outline = sphere.outline;
  const int width = outline.after_right - outline.left, offset = outline.left - sphere.column;
  for (int row = outline.top; row < outline.below; ++row) {
    const auto [distance, colour, number] = layer.run(row, outline.left);
    const float b = (static_cast<float>(row - sphere.row) - sphere.down) * unit;
    // Whole vectors: beyond the sphere nothing is met, beyond the window is room.
    for (int done = 0; done < width; done += lanes) {
      float met[lanes], half_chord[lanes], shift[lanes], ray[lanes];
      std::uint32_t nearer[lanes], any = 0;
#pragma omp simd reduction(| : any)
      for (int k = 0; k < lanes; ++k) {
        const float a = (static_cast<float>(offset + done + k) - right) * unit;
        const float square = a * a + b * b;
        const float lean = parallel ? 0.0F : a * u + b * v, turn = parallel ? 0.0F : u * b - v * a;
        const float per_length = parallel ? 1.0F : 1 / (along + 2 * lean + square);
        const float inside = squared_radius - squared_far * (square + turn * turn) * per_length;
        const float before = std::sqrt(greater(inside, 0.0F) * per_length);
        const float s = parallel ? far : far * (along + lean) * per_length;
        const float t = s - before;
        const float seen_distance = distance[done + k];
        const bool first_of_equals = (t == seen_distance) & (own_number < number[done + k]);
        nearer[k] = (inside > 0) & ((t < seen_distance) | first_of_equals) ? 1 : 0;
        any |= nearer[k];
        met[k] = t;
        half_chord[k] = before;
        ray[k] = s;
        shift[k] = parallel ? 0.0F : far * (lean + square) * per_length;
      }
      if (any == 0) continue;
#pragma omp simd
      for (int k = 0; k < lanes; ++k) {
        const float a = (static_cast<float>(offset + done + k) - right) * unit;
        // The point met, from the centre: -g d - (c - s d) with c - s d = shift d0 - s (a, b, 0).
        const float nx = parallel ? a : ray[k] * a - half_chord[k] * (u + a) - shift[k] * u;
        const float ny = parallel ? b : ray[k] * b - half_chord[k] * (v + b) - shift[k] * v;
        const float nz = -half_chord[k] - shift[k];
        const std::uint32_t shade = lit(red, green, blue, nx * per_radius, ny * per_radius, nz * per_radius);
        distance[done + k] = nearer[k] != 0 ? met[k] : distance[done + k];
        colour[done + k] = nearer[k] != 0 ? shade : colour[done + k];
        number[done + k] = nearer[k] != 0 ? own_number : number[done + k];
      }
    }
  }
}

/// Faces of the cut are lit as if they turned to the viewer, so that their colours can be read, but not all alike.
Vec3 lit_face(const Vec3& normal) {
  constexpr double turned = 2;
  return (normal - turned * Vec3::UnitZ()).normalized();
}

/// A sphere that is cut through, pixel by pixel: where its ray enters it in what is cut away, it is met where that
/// ends.
template <bool parallel>
void draw_cut_sphere(PixelLayer& layer, const SphereCloud& cloud, const Candidate& candidate, const CutRays& rays) {
  const SeenSphere sphere = cloud.seen(candidate);
  const Vec3 c = cloud.centre_seen(candidate);
  const double r = cloud.radius(candidate), unit = 1 / cloud.camera().focal();
  const auto tone = [&](int place) { return static_cast<float>(sphere.colour >> place & 0xff); };
  for (int row = sphere.outline.top; row < sphere.outline.below; ++row) {
    for (int column = sphere.outline.left; column < sphere.outline.after_right; ++column) {
      // The ray is start + t way; s is the t of its point nearest to the centre.
      const double x = (column + 0.5 - cloud.camera().centre().x) * unit;
      const double y = (row + 0.5 - cloud.camera().centre().y) * unit;
      const Vec3 start = parallel ? Vec3(x, y, 0) : Vec3::Zero(), way = parallel ? Vec3(0, 0, 1) : Vec3(x, y, 1);
      const double s = (c - start).dot(way) / way.squaredNorm();
      const double inside = r * r - (start + s * way - c).squaredNorm();
      if (inside <= 0) continue;
      const double half_chord = std::sqrt(inside / way.squaredNorm());
      const CutSpan cut = rays.span(row, column);
      double t = s - half_chord;
      const bool on_face = cut.from < t && t < cut.to;
      if (on_face) t = cut.to;
      if (on_face && t >= s + half_chord) continue;
      const auto distance = static_cast<float>(t);
      const PixelRun run = layer.run(row, column);
      if (distance > *run.distance || (distance == *run.distance && sphere.number > *run.number)) continue;
      const Vec3 normal = on_face ? lit_face(cut.normal) : Vec3((start + t * way - c) / r);
      *run.distance = distance;
      *run.number = sphere.number;
      *run.colour = lit(tone(0), tone(8), tone(16), static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                        static_cast<float>(normal.z()));
    }
  }
}

}  // namespace

void draw(PixelLayer& layer, const SphereCloud& cloud, bool cull) {
  const CutRays rays = cloud.cut_rays();
  const auto unit = static_cast<float>(1 / cloud.camera().focal());
  const bool parallel = cloud.camera().parallel();
  draw_visible(layer, cloud, cull, [&](const Candidate& candidate) {
    if (cloud.shows_cut(candidate)) {
      (parallel ? draw_cut_sphere<true> : draw_cut_sphere<false>)(layer, cloud, candidate, rays);
      return;
    }
    const bool small = candidate.outline.after_right - candidate.outline.left <= narrow;
    const auto draw_it = parallel ? (small ? draw_sphere<true, narrow> : draw_sphere<true, wide>)
                                  : (small ? draw_sphere<false, narrow> : draw_sphere<false, wide>);
    draw_it(layer, cloud.seen(candidate), unit);
  });
}

}  // namespace packstone::viz
