#include "viz/frustum_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/horizon.hpp"
#include "viz/lighting.hpp"

namespace packstone::viz {

namespace {

/// First and last column of a row that a frustum can reach: where the line between its ends comes so close to the row
/// that the box about an end, moved along it, does.
struct Columns {
  int first, last;
};

Columns columns_of(const SeenFrustum& f, int row) {
  const Point a = f.ends[0], b = f.ends[1];
  double low = 0, high = 1;  // of the way from a to b
  const double rise = b.y - a.y;
  if (rise != 0) {
    const double s = (row - f.half_height - a.y) / rise, t = (row + f.half_height - a.y) / rise;
    low = std::max(low, std::min(s, t));
    high = std::min(high, std::max(s, t));
  }
  const double entry = a.x + low * (b.x - a.x), exit = a.x + high * (b.x - a.x);
  const double left = std::floor(std::min(entry, exit) - f.half_width);
  const double right = std::ceil(std::max(entry, exit) + f.half_width);
  return {static_cast<int>(std::max<double>(left, f.outline.left)),
          static_cast<int>(std::min<double>(right, f.outline.after_right - 1))};
}

/// Where a ray meets a frustum first, and the normal there. The frustum's first end is the origin.
struct Meeting {
  double t;  // infinite: it does not
  Vec3 normal;
};

// On the ray p = m + t d the place along the axis w is h = p.w, and the side is met where
//   p^2 - h^2 = rho(h)^2,  rho = r0 + k h, 0 <= h <= L;  its normal is p - h w - k rho w.
// Both roots count: a ray can pass by the side's first meeting beyond an end and meet it again within.
Meeting meet(const SeenFrustum& f, double slope, const Vec3& m, const Vec3& d) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Vec3& w = f.axis;
  const double mh = m.dot(w), dh = d.dot(w), at_m = f.from_radius + slope * mh, widening = slope * dh;
  const double a = d.dot(d) - dh * dh - widening * widening;
  const double b = m.dot(d) - mh * dh - at_m * widening;
  const double c = m.dot(m) - mh * mh - at_m * at_m;
  const double root = b * b - a * c;
  Meeting first{never, {}};
  if (root >= 0) {
    const double q = -(b + std::copysign(std::sqrt(root), b));  // without a difference of likes
    for (const double t : {q / a, c / q}) {
      const double h = mh + t * dh, radius = f.from_radius + slope * h;
      if (!(h >= 0 && h <= f.length && t < first.t)) continue;
      first = {t, m + t * d - (h + slope * radius) * w};
      first.normal /= radius * std::sqrt(1 + slope * slope);
    }
  }
  const auto meet_end = [&](double place, double radius, const Vec3& out) {
    const double t = (place - mh) / dh;
    if (t < first.t && (m + t * d - place * w).squaredNorm() < radius * radius) first = {t, out};
  };
  meet_end(0, f.from_radius, -w);
  meet_end(f.length, f.to_radius, w);
  return first;
}

void draw_frustum(PixelLayer& layer, const SeenFrustum& f, const Camera& camera) {
  const double slope = (f.to_radius - f.from_radius) / f.length;
  const auto tone = [&](int place) { return static_cast<float>(f.colour >> place & 0xff); };
  for (int row = f.outline.top; row < f.outline.below; ++row) {
    const Columns columns = columns_of(f, row);
    if (columns.first > columns.last) continue;
    const PixelRun run = layer.run(row, columns.first);
    const double y = (row + 0.5 - camera.centre().y) / camera.focal();
    for (int column = columns.first; column <= columns.last; ++column) {
      const double x = (column + 0.5 - camera.centre().x) / camera.focal();
      // From the point of the ray that is as far as the first end, so that nothing large cancels.
      const double scale = camera.parallel() ? 1 : f.from.z();
      const Vec3 m(x * scale - f.from.x(), y * scale - f.from.y(), 0);
      const Vec3 d = camera.parallel() ? Vec3(0, 0, 1) : Vec3(x, y, 1);
      const Meeting met = meet(f, slope, m, d);
      const auto distance = static_cast<float>(f.from.z() + met.t);
      const int k = column - columns.first;
      const bool nearer = distance < run.distance[k] || (distance == run.distance[k] && f.number < run.number[k]);
      if (!std::isfinite(met.t) || !nearer) continue;
      run.distance[k] = distance;
      run.colour[k] = lit(tone(0), tone(8), tone(16), static_cast<float>(met.normal.x()),
                          static_cast<float>(met.normal.y()), static_cast<float>(met.normal.z()));
      run.number[k] = f.number;
    }
  }
}

}  // namespace

void draw(PixelLayer& layer, const FrustumCloud& cloud, bool cull) {
  draw_visible(layer, cloud, cull,
               [&](const Candidate& candidate) { draw_frustum(layer, cloud.seen(candidate), cloud.camera()); });
}

}  // namespace packstone::viz
