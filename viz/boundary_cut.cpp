#include "viz/boundary_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace packstone::viz {

namespace {

struct CutPiece {
  InPlane from;
  InPlane to;
};

/// The part of the domain in the slice, a convex polygon.
class Frame {
 public:
  explicit Frame(std::vector<InPlane> corners) : corners_(std::move(corners)) {}

  /// By its box.
  bool may_meet(const CutLine& line) const {
    const auto apart = [&](auto&& coordinate) {
      const auto [low, high] = range(corners_, coordinate);
      const auto [first, last] = range(line, coordinate);
      return first > high || last < low;
    };
    return !apart([](const InPlane& p) { return p.u; }) && !apart([](const InPlane& p) { return p.v; });
  }

  bool has_as_side(const CutPiece& s) const {
    constexpr double tolerance = 1e-6;  // of the polygon's sides
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const InPlane &a = corners_[k], &b = corners_[(k + 1) % corners_.size()];
      const double length = std::hypot(b.u - a.u, b.v - a.v);
      const auto near = [&](const InPlane& p) {
        return std::abs((b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u)) < tolerance * length * length;
      };
      if (near(s.from) && near(s.to)) return true;
    }
    return false;
  }

  /// The line of all (u, v) with n.u u + n.v v = offset, inside.
  std::optional<CutPiece> line(const InPlane& n, double offset) const {
    constexpr double parallel = 1e-9;  // to the slice's plane
    if (!(std::hypot(n.u, n.v) > parallel)) return std::nullopt;
    std::vector<InPlane> ends;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const InPlane &a = corners_[k], &b = corners_[(k + 1) % corners_.size()];
      const double at_a = n.u * a.u + n.v * a.v - offset, at_b = n.u * b.u + n.v * b.v - offset;
      if ((at_a >= 0) == (at_b >= 0)) continue;
      const double share = at_a / (at_a - at_b);
      ends.push_back({a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)});
    }
    if (ends.size() != 2) return std::nullopt;
    return CutPiece{ends[0], ends[1]};
  }

 private:
  template <class Coordinate>
  static std::pair<double, double> range(const std::vector<InPlane>& points, Coordinate&& coordinate) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const InPlane& p : points) {
      low = std::min(low, coordinate(p));
      high = std::max(high, coordinate(p));
    }
    return {low, high};
  }

  std::vector<InPlane> corners_;
};

/// Where the slice cuts a triangle; corners in its plane count as above it, so that neighbours agree.
std::optional<CutPiece> cut(const BoundaryRecord& surface, const std::array<std::int32_t, 3>& triangle,
                            const SlicePlane& plane) {
  InPlane ends[2];
  int count = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3* above = &surface.points[triangle[c]];
    const Vec3* below = &surface.points[triangle[(c + 1) % 3]];
    const auto height = [&](const Vec3* p) { return plane.height(*p); };
    if ((height(above) >= 0) == (height(below) >= 0)) continue;
    // From the upper end down, whichever way round the triangle, so that both neighbours get the same point.
    if (height(above) < 0) std::swap(above, below);
    const double share = height(above) / (height(above) - height(below));
    ends[count++] = plane.place(*above + share * (*below - *above));
  }
  if (count < 2 || ends[0] == ends[1]) return std::nullopt;
  return CutPiece{ends[0], ends[1]};
}

/// CutPieces that share an end become one line.
std::vector<CutLine> joined(const std::vector<CutPiece>& segments) {
  std::map<InPlane, std::vector<std::size_t>> meeting;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    meeting[segments[s].from].push_back(s);
    meeting[segments[s].to].push_back(s);
  }
  std::vector<bool> used(segments.size(), false);
  const auto extend = [&](CutLine& line) {
    for (;;) {
      const auto& here = meeting[line.back()];
      const auto next = std::find_if(here.begin(), here.end(), [&](std::size_t s) { return !used[s]; });
      if (next == here.end()) return;
      used[*next] = true;
      const CutPiece& s = segments[*next];
      line.push_back(s.from == line.back() ? s.to : s.from);
    }
  };
  std::vector<CutLine> lines;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (used[s]) continue;
    used[s] = true;
    CutLine line = {segments[s].from, segments[s].to};
    extend(line);
    std::reverse(line.begin(), line.end());
    extend(line);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

std::vector<CutLine> boundary_cut(const Snapshot& snapshot, const SlicePlane& plane) {
  const Frame frame(section(snapshot.domain, plane));
  std::vector<CutLine> lines;
  for (const BoundaryRecord& wall : snapshot.boundaries) {
    if (wall.kind == "plane") {
      // The slice's points are position n + u right + v up, with u and v from its origin.
      const Vec3& n = wall.normal;
      const Vec3 start = plane.origin - plane.height(plane.origin) * plane.normal;
      const auto line = frame.line({n.dot(plane.right), n.dot(plane.up)}, n.dot(wall.point - start));
      if (line && !frame.has_as_side(*line)) lines.push_back({line->from, line->to});
      continue;
    }
    std::vector<CutPiece> segments;
    for (const auto& triangle : wall.triangles) {
      if (const auto segment = cut(wall, triangle, plane)) segments.push_back(*segment);
    }
    for (CutLine& line : joined(segments)) {
      if (frame.may_meet(line)) lines.push_back(std::move(line));
    }
  }
  return lines;
}

}  // namespace packstone::viz
