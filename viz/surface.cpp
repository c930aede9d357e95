#include "viz/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace packstone::viz {

namespace {

constexpr double smallest_detail = 1e-6;  ///< points as near as this are one
const double crease = std::cos(30 * M_PI / 180);

/// Makes points that coincide one. Returns the new index of each.
std::vector<std::int32_t> weld(const std::vector<Vec3>& points, std::vector<Vec3>& kept) {
  std::vector<Vec3> place;
  place.reserve(points.size());
  for (const Vec3& p : points) place.emplace_back((p / smallest_detail).array().round());
  const auto key = [&](std::size_t i) { return std::tie(place[i].x(), place[i].y(), place[i].z()); };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<std::int32_t> index(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || key(order[k - 1]) != key(order[k])) kept.push_back(points[order[k]]);
    index[order[k]] = static_cast<std::int32_t>(kept.size() - 1);
  }
  return index;
}

/// A triangle on its own.
struct Face {
  Triangle corners;
  Vec3 normal;  ///< 0 where it has next to no area
  bool facing;  ///< its normal points to the viewer's side
  Vec3 to_viewer() const { return facing ? normal : Vec3(-normal); }
};

Face made_face(const Triangle& corners, const std::vector<Vec3>& points, const Camera& camera) {
  const Vec3& at = points[corners[0]];
  const Vec3 u = points[corners[1]] - at;
  const Vec3 v = points[corners[2]] - at;
  const Vec3 across = u.cross(v);
  const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
  const bool flat = across.norm() <= smallest_detail * longest;
  const Vec3 normal = flat ? Vec3(Vec3::Zero()) : across.normalized();
  return {corners, normal, camera.sees(at, normal)};
}

/// An edge as one of its triangles has it.
struct HalfEdge {
  std::int32_t low, high;  ///< its points
  std::size_t face;
  std::size_t at_low, at_high;  ///< corners of all faces, counted through
  bool ascending;               ///< the way round the triangle
};

std::vector<HalfEdge> sorted_edges(const std::vector<Face>& faces) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t next = (c + 1) % 3;
      const std::int32_t from = faces[f].corners[c];
      const std::int32_t to = faces[f].corners[next];
      if (from < to) {
        edges.push_back({from, to, f, 3 * f + c, 3 * f + next, true});
      } else {
        edges.push_back({to, from, f, 3 * f + next, 3 * f + c, false});
      }
    }
  }
  const auto key = [](const HalfEdge& s) { return std::tie(s.low, s.high, s.face); };
  std::sort(edges.begin(), edges.end(), [&](const HalfEdge& a, const HalfEdge& b) { return key(a) < key(b); });
  return edges;
}

/// Sets of corners that share a normal.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// True where the surface goes on smoothly from one triangle to the other, in the viewer's sight as well.
bool smooth(const Face& a, const Face& b, bool same_way_round) {
  if ((a.facing == b.facing) != same_way_round) return false;
  return a.to_viewer().dot(b.to_viewer()) > crease;
}

std::vector<Vec3> corner_normals(const std::vector<Face>& faces, const std::vector<Vec3>& points, Sets& sets) {
  std::vector<Vec3> sum(3 * faces.size(), Vec3::Zero());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      // By the angle, so that it does not matter how a flat part is cut into triangles.
      const Vec3& at = points[faces[f].corners[c]];
      const Vec3 u = points[faces[f].corners[(c + 1) % 3]] - at;
      const Vec3 v = points[faces[f].corners[(c + 2) % 3]] - at;
      sum[sets.of(3 * f + c)] += std::atan2(u.cross(v).norm(), u.dot(v)) * faces[f].to_viewer();
    }
  }
  std::vector<Vec3> normals(sum.size());
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const Vec3 own = faces[i / 3].to_viewer();
    const Vec3 shared = sum[sets.of(i)].normalized();
    normals[i] = shared.dot(own) > crease ? shared : own;  // round the tip of a cone they have little in common
  }
  return normals;
}

}  // namespace

SeenSurface seen_surface(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, bool one_sided,
                         const Camera& camera) {
  SeenSurface seen;
  const std::vector<std::int32_t> index = weld(points, seen.points);
  std::vector<Face> faces;
  faces.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const Triangle corners = {index[t[0]], index[t[1]], index[t[2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    faces.push_back(made_face(corners, seen.points, camera));
  }

  Sets sets(3 * faces.size());
  const std::vector<HalfEdge> edges = sorted_edges(faces);
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    const HalfEdge& a = edges[first];
    while (last < edges.size() && edges[last].low == a.low && edges[last].high == a.high) ++last;
    if (last - first == 2) {
      const HalfEdge& b = edges[first + 1];
      const Face& of_a = faces[a.face];
      const Face& of_b = faces[b.face];
      if (of_a.normal.isZero(0) || of_b.normal.isZero(0)) continue;  // a sliver between larger triangles
      if (smooth(of_a, of_b, a.ascending != b.ascending)) {
        sets.unite(a.at_low, b.at_low);
        sets.unite(a.at_high, b.at_high);
        continue;
      }
    }
    seen.lines.push_back({a.low, a.high});
  }

  const std::vector<Vec3> normals = corner_normals(faces, seen.points, sets);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (one_sided && !faces[f].facing) continue;
    seen.triangles.push_back(faces[f].corners);
    seen.normals.push_back({normals[3 * f], normals[3 * f + 1], normals[3 * f + 2]});
  }
  return seen;
}

}  // namespace packstone::viz
