#include "engine/boundary/round_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace packstone::engine {

namespace {

/// Facets about the axis, of surfaces as drawn; spheres touch the true shape.
constexpr int drawn_facets = 96;

/// A point of the line that is turned about the axis: radius and height [m].
using ProfilePoint = std::array<double, 2>;

std::vector<ProfilePoint> profile_of(const BoundarySpec& b, const Domain& domain) {
  const auto closed = [&](End end) { return std::count(b.closed.begin(), b.closed.end(), end) > 0; };
  std::vector<ProfilePoint> line;
  if (b.kind == BoundaryKind::funnel) {
    const double tube = b.tube_length.value_or(0), top = *b.cone_length, bin = b.length.value_or(0);
    if (tube > 0) line.push_back({*b.outlet_radius, -tube});
    line.push_back({*b.outlet_radius, 0});
    line.push_back({*b.radius, top});
    if (bin > 0) line.push_back({*b.radius, top + bin});
    for (ProfilePoint& p : line) p[1] += tube;
  } else if (b.length) {
    line = {{*b.radius, 0}, {b.top_radius.value_or(*b.radius), *b.length}};
  } else {
    // Farther than any particle gets, whose centres may be a domain's length outside of it.
    const double far = 4 * (domain.size().norm() + (*b.point - domain.min).norm() + (*b.point - domain.max).norm());
    line = {{*b.radius, -far}, {*b.radius, far}};
  }
  if (closed(bottom_end) && line.front()[0] > 0) line.insert(line.begin(), {0, line.front()[1]});
  if (closed(top_end) && line.back()[0] > 0) line.push_back({0, line.back()[1]});
  return line;
}

void add_pieces(Shape& shape, const Vec3& origin, const Vec3& axis, const std::vector<ProfilePoint>& line) {
  std::vector<RoundPiece> rounds;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double dr = line[k + 1][0] - line[k][0], dh = line[k + 1][1] - line[k][1], length = std::hypot(dr, dh);
    rounds.push_back({origin, axis, line[k][0], line[k][1], dr / length, dh / length, length});
    shape.pieces.emplace_back(rounds.back());
  }
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k][0] == 0 && (k == 0 || k + 1 == line.size())) continue;  // the middle of a lid, or a cone's tip
    RimPiece rim{origin, axis, line[k][0], line[k][1], {}, 0};
    if (k > 0) rim.lines[rim.count++] = {-rounds[k - 1].along_radius, -rounds[k - 1].along_height};
    if (k < rounds.size()) rim.lines[rim.count++] = {rounds[k].along_radius, rounds[k].along_height};
    shape.pieces.emplace_back(rim);
  }
}

/// The surface in facets, its normals towards the axis.
void draw(BoundaryRecord& record, const Vec3& origin, const Vec3& axis, const std::vector<ProfilePoint>& line) {
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  for (const ProfilePoint& p : line) {
    for (int k = 0; k < drawn_facets; ++k) {
      const double angle = 2 * std::numbers::pi * k / drawn_facets;
      record.points.push_back(origin + p[1] * axis + p[0] * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  for (std::size_t ring = 0; ring + 1 < line.size(); ++ring) {
    const auto first = static_cast<std::int32_t>(ring) * drawn_facets;
    for (std::int32_t k = 0; k < drawn_facets; ++k) {
      const std::int32_t a = first + k, b = first + (k + 1) % drawn_facets;
      const std::int32_t c = a + drawn_facets, d = b + drawn_facets;
      if (line[ring][0] > 0) record.triangles.push_back({a, c, b});
      if (line[ring + 1][0] > 0) record.triangles.push_back({b, c, d});
    }
  }
}

/// Of the shape at a height; beyond its ends as at them, so that particles can fall in from above.
double radius_at(const std::vector<ProfilePoint>& line, double height) {
  const double within = std::clamp(height, line.front()[1], line.back()[1]);
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const auto& [r, h] = line[k];
    const auto& [next_r, next_h] = line[k + 1];
    if (h < next_h && within <= next_h) return r + (within - h) / (next_h - h) * (next_r - r);
  }
  return line.back()[0];
}

/// Whether a height is outside of an end that has a lid.
bool beyond_lid(const std::vector<ProfilePoint>& line, double height) {
  const bool below = line.front()[0] == 0 && height < line.front()[1];
  return below || (line.back()[0] == 0 && height > line.back()[1]);
}

/// The part of an endless cylinder's line that is worth drawing.
std::vector<ProfilePoint> drawn_part(std::vector<ProfilePoint> line, const BoundarySpec& b, const Vec3& origin,
                                     const Vec3& axis, const Domain& domain) {
  if (b.kind != BoundaryKind::cylinder || b.length) return line;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? domain.max[0] : domain.min[0], corner & 2 ? domain.max[1] : domain.min[1],
                 corner & 4 ? domain.max[2] : domain.min[2]);
    low = std::min(low, axis.dot(p - origin));
    high = std::max(high, axis.dot(p - origin));
  }
  line.front()[1] = low;
  line.back()[1] = high;
  return line;
}

}  // namespace

Shape round_shape(const BoundarySpec& b, const Domain& domain) {
  Shape shape;
  const Vec3 origin = *b.point, axis = b.axis.value_or(Vec3::UnitZ()).normalized();
  const std::vector<ProfilePoint> line = profile_of(b, domain);
  add_pieces(shape, origin, axis, line);
  shape.finish();
  BoundaryRecord& record = shape.record;
  draw(record, origin, axis, drawn_part(line, b, origin, axis, domain));
  if (b.kind == BoundaryKind::cylinder) {
    record.axis = axis;
    record.cross_section = std::numbers::pi * *b.radius * *b.radius;
  }
  if (std::count(b.closed.begin(), b.closed.end(), bottom_end) > 0) {
    record.point = origin;
    record.normal = axis;
  }
  shape.encloses = [=](const Vec3& p) {
    const double height = axis.dot(p - origin);
    return !beyond_lid(line, height) && (p - origin - height * axis).norm() < radius_at(line, height);
  };
  return shape;
}

}  // namespace packstone::engine
