#include "analysis/structure/window.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/bed.hpp"

namespace packstone::analysis {

namespace {

constexpr double aligned = 1 - 1e-9;  // least component of a normal along an axis
constexpr double whole = 1 - 1e-9;    // least scale that is no shrinking

using Point2 = Eigen::Vector2d;

/// The part of a polygon where sign * (coordinate - limit) >= 0.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, int axis, double sign, double limit) {
  std::vector<Vec3> result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double at_a = sign * (a[axis] - limit), at_b = sign * (b[axis] - limit);
    if (at_a >= 0) result.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) result.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return result;
}

/// Smallest max(|x|, |y|) on a segment: at an end or where x, y, x - y or x + y is 0.
double least_on_segment(const Point2& a, const Point2& b) {
  const auto size = [](const Point2& p) { return p.cwiseAbs().maxCoeff(); };
  double least = std::min(size(a), size(b));
  const Point2 d = b - a;
  for (const Point2& row : {Point2(1, 0), Point2(0, 1), Point2(1, -1), Point2(1, 1)}) {
    const double slope = row.dot(d);
    if (slope == 0) continue;
    const double t = std::clamp(-row.dot(a) / slope, 0.0, 1.0);
    least = std::min(least, size(a + t * d));
  }
  return least;
}

/// Smallest max(|x|, |y|) on a convex polygon; 0 when the origin is inside.
double least_on_polygon(const std::vector<Point2>& polygon) {
  double least = std::numeric_limits<double>::infinity();
  bool left = true, right = true;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    least = std::min(least, least_on_segment(a, b));
    const double turn = a.x() * b.y() - a.y() * b.x();
    left = left && turn > 0;
    right = right && turn < 0;
  }
  return left || right ? 0 : least;
}

/// How far a box may be scaled across up about its centre before it meets what stands in it.
class Shrinking {
 public:
  Shrinking(const Window& box, int up)
      : box_(box),
        up_(up),
        across_{(up + 1) % 3, (up + 2) % 3},
        centre_((box.min + box.max) / 2),
        half_(box.size() / 2) {}

  void meet_plane(const Vec3& normal, const Vec3& point) {
    const double room = normal.dot(centre_ - point) - std::abs(normal[up_]) * half_[up_];
    const double need =
        std::abs(normal[across_[0]]) * half_[across_[0]] + std::abs(normal[across_[1]]) * half_[across_[1]];
    if (need > 0) scale_ = std::min(scale_, std::max(0.0, room / need));
  }

  void meet_triangle(const std::vector<Vec3>& corners) {
    const auto part = clipped(clipped(corners, up_, 1, box_.min[up_]), up_, -1, box_.max[up_]);
    std::vector<Point2> seen;
    for (const Vec3& p : part) {
      seen.emplace_back((p[across_[0]] - centre_[across_[0]]) / half_[across_[0]],
                        (p[across_[1]] - centre_[across_[1]]) / half_[across_[1]]);
    }
    if (!seen.empty()) scale_ = std::min(scale_, least_on_polygon(seen));
  }

  Window shrunk() const {
    Window window = box_;
    if (scale_ >= whole) return window;
    for (const int k : across_) {
      window.min[k] = centre_[k] - scale_ * half_[k];
      window.max[k] = centre_[k] + scale_ * half_[k];
      window.periodic[k] = false;
    }
    return window;
  }

 private:
  Window box_;
  int up_;
  std::array<int, 2> across_;
  Vec3 centre_, half_;
  double scale_ = 1;
};

bool is_plane(const BoundaryRecord& boundary) { return boundary.kind == "plane" && !boundary.normal.isZero(0); }

/// Cuts the box by planes across an axis.
void cut_by_aligned_planes(Window& box, const Snapshot& snapshot) {
  for (const BoundaryRecord& boundary : snapshot.boundaries) {
    if (!is_plane(boundary)) continue;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(boundary.normal[k]) < aligned) continue;
      const double at = boundary.point[k];
      if (boundary.normal[k] > 0 && at > box.min[k]) {
        box.min[k] = at;
        box.periodic[k] = false;
      } else if (boundary.normal[k] < 0 && at < box.max[k]) {
        box.max[k] = at;
        box.periodic[k] = false;
      }
    }
  }
}

bool has_volume(const Window& window) { return (window.size().array() > 0).all(); }

}  // namespace

WindowOrReason bulk_window(const Snapshot& snapshot, const Context& context, double inset) {
  const BedFrame& frame = context.frame;
  Window box{snapshot.domain.min, snapshot.domain.max, snapshot.domain.periodic};
  if (!frame.periodic) {
    if (!(context.bed.height > 0)) return {{}, snapshot.size() == 0 ? "no particles" : "the bed has no height"};
    const double a = frame.floor + frame.sign * bulk_lower * context.bed.height;
    const double b = frame.floor + frame.sign * bulk_upper * context.bed.height;
    box.min[frame.axis] = std::max(box.min[frame.axis], std::min(a, b));
    box.max[frame.axis] = std::min(box.max[frame.axis], std::max(a, b));
  }
  cut_by_aligned_planes(box, snapshot);
  const std::string reason = "no box in the bulk is free of boundaries";
  if (!has_volume(box)) return {{}, reason};

  Shrinking shrinking(box, frame.axis);
  for (const BoundaryRecord& boundary : snapshot.boundaries) {
    if (is_plane(boundary) && boundary.normal.cwiseAbs().maxCoeff() < aligned) {
      shrinking.meet_plane(boundary.normal, boundary.point);
    }
    for (const auto& t : boundary.triangles) {
      shrinking.meet_triangle({boundary.points[static_cast<std::size_t>(t[0])],
                               boundary.points[static_cast<std::size_t>(t[1])],
                               boundary.points[static_cast<std::size_t>(t[2])]});
    }
  }
  Window window = shrinking.shrunk();
  for (int k = 0; k < 3; ++k) {
    if (window.periodic[k] || k == frame.axis) continue;
    window.min[k] += inset;
    window.max[k] -= inset;
  }
  if (!has_volume(window)) return {{}, reason};
  return {window, ""};
}

}  // namespace packstone::analysis
