#include "viz/boundary_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace packstone::viz {

namespace {

using Place = std::array<double, 2>;

struct Segment {
  Place from;
  Place to;
};

/// The part of the domain in the slice.
struct Frame {
  Place low;
  Place high;

  Frame(const Domain& domain, PlaneAxes axes)
      : low{domain.min[axes.u], domain.min[axes.v]}, high{domain.max[axes.u], domain.max[axes.v]} {}

  bool may_meet(const CutLine& line) const {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto beyond = [&](const Place& p) { return p[k] > high[k]; };
      const auto before = [&](const Place& p) { return p[k] < low[k]; };
      if (std::all_of(line.begin(), line.end(), beyond) || std::all_of(line.begin(), line.end(), before)) return false;
    }
    return true;
  }

  bool has_as_side(const Segment& s) const {
    constexpr double tolerance = 1e-6;
    for (std::size_t k = 0; k < 2; ++k) {
      const double near = tolerance * (high[k] - low[k]);
      for (const double side : {low[k], high[k]}) {
        if (std::abs(s.from[k] - side) < near && std::abs(s.to[k] - side) < near) return true;
      }
    }
    return false;
  }
};

/// The line of all (u, v) with n.x u + n.y v = offset, inside the frame.
std::optional<Segment> line_in_frame(const Place& n, double offset, const Frame& frame) {
  const double length = std::hypot(n[0], n[1]);
  constexpr double parallel = 1e-9;  // to the slice's plane
  if (!(length > parallel)) return std::nullopt;
  const Place along = {-n[1] / length, n[0] / length};
  // From the foot of the middle of the frame, which is exact where the frame is small and far from the origin.
  Place foot = {(frame.low[0] + frame.high[0]) / 2, (frame.low[1] + frame.high[1]) / 2};
  const double beside = (offset - n[0] * foot[0] - n[1] * foot[1]) / (length * length);
  for (std::size_t k = 0; k < 2; ++k) foot[k] += beside * n[k];
  double first = -std::numeric_limits<double>::infinity();
  double last = -first;
  for (std::size_t k = 0; k < 2; ++k) {
    if (along[k] == 0) {
      if (foot[k] < frame.low[k] || foot[k] > frame.high[k]) return std::nullopt;
      continue;
    }
    const auto [a, b] = std::minmax({(frame.low[k] - foot[k]) / along[k], (frame.high[k] - foot[k]) / along[k]});
    first = std::max(first, a);
    last = std::min(last, b);
  }
  if (!(first < last)) return std::nullopt;
  const auto at = [&](double way) { return Place{foot[0] + way * along[0], foot[1] + way * along[1]}; };
  return Segment{at(first), at(last)};
}

/// Where the slice cuts a triangle; corners in its plane count as above it, so that neighbours agree.
std::optional<Segment> cut(const BoundaryRecord& surface, const std::array<std::int32_t, 3>& triangle,
                           const SlicePlane& plane, PlaneAxes axes) {
  Place ends[2];
  int count = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3* above = &surface.points[triangle[c]];
    const Vec3* below = &surface.points[triangle[(c + 1) % 3]];
    const auto height = [&](const Vec3* p) { return (*p)[plane.axis] - plane.position; };
    if ((height(above) >= 0) == (height(below) >= 0)) continue;
    // From the upper end down, whichever way round the triangle, so that both neighbours get the same point.
    if (height(above) < 0) std::swap(above, below);
    const double share = height(above) / (height(above) - height(below));
    const Vec3 p = *above + share * (*below - *above);
    ends[count++] = {p[axes.u], p[axes.v]};
  }
  if (count < 2 || ends[0] == ends[1]) return std::nullopt;
  return Segment{ends[0], ends[1]};
}

/// Segments that share an end become one line.
std::vector<CutLine> joined(const std::vector<Segment>& segments) {
  std::map<Place, std::vector<std::size_t>> meeting;
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
      const Segment& s = segments[*next];
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
  const PlaneAxes axes = axes_in_plane(plane.axis);
  const Frame frame(snapshot.domain, axes);
  std::vector<CutLine> lines;
  for (const BoundaryRecord& wall : snapshot.boundaries) {
    if (wall.kind == "plane") {
      const Vec3& n = wall.normal;
      const double offset = n.dot(wall.point) - n[plane.axis] * plane.position;
      const auto line = line_in_frame({n[axes.u], n[axes.v]}, offset, frame);
      if (line && !frame.has_as_side(*line)) lines.push_back({line->from, line->to});
      continue;
    }
    std::vector<Segment> segments;
    for (const auto& triangle : wall.triangles) {
      if (const auto segment = cut(wall, triangle, plane, axes)) segments.push_back(*segment);
    }
    for (CutLine& line : joined(segments)) {
      if (frame.may_meet(line)) lines.push_back(std::move(line));
    }
  }
  return lines;
}

}  // namespace packstone::viz
