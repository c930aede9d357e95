#include "engine/boundary/flat_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

namespace packstone::engine {

namespace {

constexpr double rounding = 1e-9;          ///< of lengths, as a share of the surface's size
constexpr double flat_cosine = 1 - 1e-9;   ///< sides of triangles that lie in one plane within 5e-5 rad are no edges
constexpr double polygon_flatness = 1e-3;  ///< of a polygon, as a share of its size

using TriangleSide = std::array<std::int32_t, 2>;

TriangleSide side_of(const std::array<std::int32_t, 3>& triangle, int k) {
  const std::int32_t a = triangle[k], b = triangle[(k + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

/// The triangles at each side.
std::map<TriangleSide, std::vector<std::int32_t>> triangles_at_sides(const TriangleSurface& surface) {
  std::map<TriangleSide, std::vector<std::int32_t>> at;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) at[side_of(surface.triangles[t], k)].push_back(static_cast<std::int32_t>(t));
  }
  return at;
}

Vec3 area_vector(const TriangleSurface& s, const std::array<std::int32_t, 3>& t) {
  return 0.5 * (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
}

TrianglePiece triangle_piece(const TriangleSurface& s, const std::array<std::int32_t, 3>& t) {
  TrianglePiece piece;
  for (int k = 0; k < 3; ++k) piece.corner[k] = s.points[t[k]];
  piece.normal = area_vector(s, t).normalized();
  for (int k = 0; k < 3; ++k) {
    // From the same ends for both triangles at a side.
    const TriangleSide side = side_of(t, k);
    const Vec3 along = (s.points[side[1]] - s.points[side[0]]).normalized();
    Vec3 outward = along.cross(piece.normal).normalized();
    if (outward.dot(s.points[t[(k + 2) % 3]] - s.points[side[0]]) > 0) outward = -outward;
    piece.inside[k] = {outward, outward.dot(s.points[side[0]])};
  }
  return piece;
}

Vec3 newell_normal(const std::vector<Vec3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    sum += (corners[k] - corners[0]).cross(corners[(k + 1) % corners.size()] - corners[0]);
  }
  return 0.5 * sum;
}

double size_of(const std::vector<Vec3>& points) {
  Extent extent;
  for (const Vec3& p : points) extent.add(p);
  return extent.empty() ? 0 : (extent.high - extent.low).norm();
}

}  // namespace

TriangleSurface welded(const TriangleSurface& surface) {
  const double grain = rounding * size_of(surface.points);
  TriangleSurface result;
  std::map<std::array<std::int64_t, 3>, std::int32_t> places;
  std::vector<std::int32_t> index;
  for (const Vec3& p : surface.points) {
    std::array<std::int64_t, 3> place;
    for (int k = 0; k < 3; ++k) place[k] = grain > 0 ? std::llround(p[k] / grain) : 0;
    const auto [found, is_new] = places.try_emplace(place, static_cast<std::int32_t>(result.points.size()));
    if (is_new) result.points.push_back(p);
    index.push_back(found->second);
  }
  for (const auto& t : surface.triangles) {
    const std::array<std::int32_t, 3> corners = {index[t[0]], index[t[1]], index[t[2]]};
    const double longest = std::max({(result.points[corners[1]] - result.points[corners[0]]).norm(),
                                     (result.points[corners[2]] - result.points[corners[1]]).norm(),
                                     (result.points[corners[0]] - result.points[corners[2]]).norm()});
    if (area_vector(result, corners).norm() > rounding * longest * longest) result.triangles.push_back(corners);
  }
  return result;
}

std::vector<std::array<Vec3, 2>> open_sides(const TriangleSurface& surface) {
  std::vector<std::array<Vec3, 2>> open;
  for (const auto& [side, triangles] : triangles_at_sides(surface)) {
    if (triangles.size() != 2) open.push_back({surface.points[side[0]], surface.points[side[1]]});
  }
  return open;
}

TriangleSurface oriented_inwards(const TriangleSurface& surface) {
  TriangleSurface result = surface;
  const auto at = triangles_at_sides(surface);
  std::vector<bool> done(surface.triangles.size(), false);
  for (std::size_t first = 0; first < done.size(); ++first) {
    if (done[first]) continue;
    std::vector<std::int32_t> part = {static_cast<std::int32_t>(first)};
    done[first] = true;
    double volume = 0;
    for (std::size_t n = 0; n < part.size(); ++n) {
      const std::array<std::int32_t, 3> own = result.triangles[part[n]];
      volume += result.points[own[0]].dot(area_vector(result, own));
      for (int k = 0; k < 3; ++k) {
        for (const std::int32_t next : at.at(side_of(own, k))) {
          if (done[next]) continue;
          done[next] = true;
          part.push_back(next);
          auto& other = result.triangles[next];
          for (int j = 0; j < 3; ++j) {
            if (other[j] == own[k] && other[(j + 1) % 3] == own[(k + 1) % 3]) {
              std::swap(other[0], other[1]);
              break;
            }
          }
        }
      }
    }
    if (volume <= 0) continue;
    for (const std::int32_t t : part) std::swap(result.triangles[t][0], result.triangles[t][1]);
  }
  return result;
}

Shape flat_shape(const TriangleSurface& surface) {
  Shape shape;
  std::vector<TrianglePiece> triangles;
  for (const auto& t : surface.triangles) {
    triangles.push_back(triangle_piece(surface, t));
    shape.pieces.emplace_back(triangles.back());
  }
  std::map<std::int32_t, std::vector<TriangleSide>> sides_at_corner;
  std::map<std::int32_t, bool> sharp;  // whether an edge ends at the corner
  for (const auto& [side, at] : triangles_at_sides(surface)) {
    std::vector<HalfSpace> slabs;
    for (const std::int32_t t : at) {
      for (int k = 0; k < 3; ++k) {
        if (side_of(surface.triangles[t], k) == side) slabs.push_back(triangles[t].inside[k]);
      }
    }
    const bool flat = slabs.size() == 2 && -slabs[0].normal.dot(slabs[1].normal) > flat_cosine;
    for (const std::int32_t corner : side) {
      sides_at_corner[corner].push_back(side);
      sharp[corner] = sharp[corner] || !flat;
    }
    if (flat) continue;
    const Vec3 &start = surface.points[side[0]], along = surface.points[side[1]] - start;
    const auto first = static_cast<std::int32_t>(shape.slabs.size());
    shape.slabs.insert(shape.slabs.end(), slabs.begin(), slabs.end());
    shape.pieces.emplace_back(
        EdgePiece{start, along.normalized(), along.norm(), first, static_cast<std::int32_t>(shape.slabs.size())});
  }
  for (const auto& [corner, sides] : sides_at_corner) {
    if (!sharp[corner]) continue;
    const Vec3& point = surface.points[corner];
    const auto first = static_cast<std::int32_t>(shape.slabs.size());
    for (const TriangleSide& side : sides) {
      const Vec3 along = (surface.points[side[side[0] == corner ? 1 : 0]] - point).normalized();
      shape.slabs.push_back({along, along.dot(point)});
    }
    shape.pieces.emplace_back(CornerPiece{point, first, static_cast<std::int32_t>(shape.slabs.size())});
  }
  shape.record.points = surface.points;
  shape.record.triangles = surface.triangles;
  shape.finish();
  return shape;
}

Shape box_shape(const Vec3& min, const Vec3& max, const std::vector<int>& open) {
  std::vector<std::vector<Vec3>> faces;
  for (int face = 0; face < 6; ++face) {
    if (std::count(open.begin(), open.end(), face) > 0) continue;
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool upper = face % 2 == 1;
    std::vector<Vec3> corners(4, upper ? max : min);
    const double us[] = {min[u], max[u], max[u], min[u]}, vs[] = {min[v], min[v], max[v], max[v]};
    for (int k = 0; k < 4; ++k) {  // counter-clockwise seen from the inside
      const int at = upper ? 3 - k : k;
      corners[k][u] = us[at];
      corners[k][v] = vs[at];
    }
    faces.push_back(corners);
  }
  Shape shape = flat_shape(welded(triangulated(faces)));
  shape.encloses = [=](const Vec3& p) {
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const bool beyond = face % 2 ? p[axis] > max[axis] : p[axis] < min[axis];
      if (beyond && std::count(open.begin(), open.end(), face) == 0) return false;
    }
    return true;
  };
  return shape;
}

std::string fault_of_polygon(const std::vector<Vec3>& corners) {
  const double size = size_of(corners);
  const Vec3 area = newell_normal(corners);
  if (area.norm() <= rounding * size * size) return "has no area: its corners lie on a line or cross over";
  const Vec3 normal = area.normalized();
  double turned = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double off = normal.dot(corners[k] - corners[0]);
    if (std::abs(off) > polygon_flatness * size) {
      return fmt::format("is not flat: corner {} is {:.3g} m off the plane of the others; split it into triangles", k,
                         off);
    }
    const Vec3 before = corners[k] - corners[(k + corners.size() - 1) % corners.size()];
    const Vec3 after = corners[(k + 1) % corners.size()] - corners[k];
    if (after.norm() <= rounding * size) {
      return fmt::format("has corner {} twice in a row; the last corner is joined to the first without repeating it",
                         k);
    }
    const double turn = normal.dot(before.cross(after));
    if (turn < -rounding * size * size) {
      return fmt::format("is not convex at corner {}; split it into convex ones", k);
    }
    turned += std::atan2(turn, before.dot(after));
  }
  if (turned > 3 * std::numbers::pi) return "winds round more than once; give its corners in order";
  return {};
}

TriangleSurface triangulated(const std::vector<std::vector<Vec3>>& polygons) {
  TriangleSurface surface;
  for (const auto& corners : polygons) {
    const auto first = static_cast<std::int32_t>(surface.points.size());
    surface.points.insert(surface.points.end(), corners.begin(), corners.end());
    for (std::int32_t k = 1; k + 1 < static_cast<std::int32_t>(corners.size()); ++k) {
      surface.triangles.push_back({first, first + k, first + k + 1});
    }
  }
  return surface;
}

}  // namespace packstone::engine
