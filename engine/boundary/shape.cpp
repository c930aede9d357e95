#include "engine/boundary/shape.hpp"

#include <algorithm>
#include <cmath>

namespace packstone::engine {

namespace {

/// Triangles take what lies this share of their size beyond their sides, so that rounding leaves no gap between them.
constexpr double seam = 1e-9;

/// A point seen from an axis: at which distance, how high, in which direction.
struct Meridian {
  double radius, height;
  Vec3 outward;

  template <class Round>
  Meridian(const Round& piece, const Vec3& p) {
    const Vec3 d = p - piece.origin;
    height = d.dot(piece.axis);
    const Vec3 across = d - height * piece.axis;
    radius = across.norm();
    outward = radius > 0 ? Vec3(across / radius) : piece.axis.unitOrthogonal();
  }
};

/// Place along the line of a round piece, and signed distance from it.
struct OnLine {
  double along, off;

  OnLine(const RoundPiece& piece, const Meridian& at) {
    const double dr = at.radius - piece.radius, dh = at.height - piece.height;
    along = dr * piece.along_radius + dh * piece.along_height;
    off = dh * piece.along_radius - dr * piece.along_height;
  }
};

double signed_distance(const TrianglePiece& piece, const Vec3& p) { return piece.normal.dot(p - piece.corner[0]); }

double size_of(const TrianglePiece& piece) { return (piece.corner[1] - piece.corner[0]).norm(); }

bool above(const TrianglePiece& piece, const Vec3& p) {
  const double allowed = seam * size_of(piece);
  return std::all_of(piece.inside.begin(), piece.inside.end(),
                     [&](const HalfSpace& side) { return side.beyond(p) <= allowed; });
}

double segment_distance(const Vec3& start, const Vec3& direction, double length, const Vec3& p) {
  const double t = std::clamp(direction.dot(p - start), 0.0, length);
  return (p - start - t * direction).norm();
}

std::int8_t sign(double x) { return x < 0 ? -1 : 1; }

/// Of a piece with two sides, from the signed distance along its normal.
bool touch_face(double off, bool faces, double reach, std::int8_t& side) {
  if (!faces || std::abs(off) >= reach) side = sign(off);
  return faces;
}

/// Of a point or circle: from a vector that ends at the centre.
bool touch_point(const Vec3& to_centre, Touch& at) {
  at.distance = to_centre.norm();
  if (at.distance == 0) return false;  // no direction to be pushed in
  at.normal = to_centre / at.distance;
  at.turning = 1 / at.distance;
  return true;
}

struct Toucher {
  const std::vector<HalfSpace>& slabs;
  const Vec3& p;
  double reach;
  std::int8_t& side;
  Touch& at;

  bool operator()(const PlanePiece& piece) const {
    at = {piece.normal, piece.normal.dot(p) - piece.height, 0, 0, Vec3::Zero()};
    return true;
  }

  bool operator()(const TrianglePiece& piece) const {
    const double off = signed_distance(piece, p);
    if (!touch_face(off, above(piece, p), reach, side)) return false;
    at = {side * piece.normal, side * off, 0, 0, Vec3::Zero()};
    return true;
  }

  bool operator()(const EdgePiece& piece) const {
    const double t = piece.direction.dot(p - piece.start);
    if (t <= 0 || t >= piece.length) return false;
    for (std::int32_t k = piece.first; k < piece.last; ++k) {
      if (slabs[k].beyond(p) <= 0) return false;
    }
    if (!touch_point(p - piece.start - t * piece.direction, at)) return false;
    at.turning_along = -at.turning;  // along the edge it does not turn
    at.direction = piece.direction;
    return true;
  }

  bool operator()(const CornerPiece& piece) const {
    for (std::int32_t k = piece.first; k < piece.last; ++k) {
      if (slabs[k].beyond(p) > 0) return false;
    }
    at.turning_along = 0;
    at.direction.setZero();
    return touch_point(p - piece.point, at);
  }

  bool operator()(const RoundPiece& piece) const {
    const Meridian m(piece, p);
    const OnLine line(piece, m);
    if (!touch_face(line.off, line.along >= 0 && line.along <= piece.length, reach, side)) return false;
    const double outward = -side * piece.along_height;
    at.normal = outward * m.outward + side * piece.along_radius * piece.axis;
    at.distance = side * line.off;
    at.turning = 0;
    at.turning_along = m.radius > 0 ? outward / m.radius : 0;
    at.direction = piece.axis.cross(m.outward);
    return true;
  }

  bool operator()(const RimPiece& piece) const {
    const Meridian m(piece, p);
    const double dr = m.radius - piece.radius, dh = m.height - piece.height;
    for (int k = 0; k < piece.count; ++k) {
      if (dr * piece.lines[k][0] + dh * piece.lines[k][1] > 0) return false;
    }
    if (!touch_point(dr * m.outward + dh * piece.axis, at)) return false;
    at.direction = piece.axis.cross(m.outward);
    at.turning_along = (m.radius > 0 ? at.normal.dot(m.outward) / m.radius : 0) - at.turning;
    return true;
  }
};

struct Distance {
  const Vec3& p;

  double operator()(const PlanePiece& piece) const { return piece.normal.dot(p) - piece.height; }
  double operator()(const TrianglePiece& piece) const {
    if (above(piece, p)) return std::abs(signed_distance(piece, p));
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const Vec3 along = piece.corner[(k + 1) % 3] - piece.corner[k];
      nearest = std::min(nearest, segment_distance(piece.corner[k], along.normalized(), along.norm(), p));
    }
    return nearest;
  }
  double operator()(const EdgePiece& piece) const {
    return segment_distance(piece.start, piece.direction, piece.length, p);
  }
  double operator()(const CornerPiece& piece) const { return (p - piece.point).norm(); }
  double operator()(const RoundPiece& piece) const {
    const OnLine line(piece, Meridian(piece, p));
    const double beyond = std::max({-line.along, line.along - piece.length, 0.0});
    return std::hypot(beyond, line.off);
  }
  double operator()(const RimPiece& piece) const {
    const Meridian m(piece, p);
    return std::hypot(m.radius - piece.radius, m.height - piece.height);
  }
};

struct SideOf {
  const Vec3& p;

  std::int8_t operator()(const TrianglePiece& piece) const { return sign(signed_distance(piece, p)); }
  std::int8_t operator()(const RoundPiece& piece) const { return sign(OnLine(piece, Meridian(piece, p)).off); }
  template <class Other>
  std::int8_t operator()(const Other&) const {
    return 1;
  }
};

/// Of a circle about an axis.
void add_circle(Extent& extent, const Vec3& origin, const Vec3& axis, double radius, double height) {
  const Vec3 centre = origin + height * axis;
  const Vec3 reach = radius * (1 - axis.array().square()).max(0).sqrt().matrix();
  extent.add(Vec3(centre - reach));
  extent.add(Vec3(centre + reach));
}

struct ExtentOf {
  Extent operator()(const PlanePiece&) const {
    const Vec3 everywhere = Vec3::Constant(std::numeric_limits<double>::infinity());
    return {-everywhere, everywhere};
  }
  Extent operator()(const TrianglePiece& piece) const {
    Extent extent;
    for (const Vec3& corner : piece.corner) extent.add(corner);
    return extent;
  }
  Extent operator()(const EdgePiece& piece) const {
    Extent extent;
    extent.add(piece.start);
    extent.add(Vec3(piece.start + piece.length * piece.direction));
    return extent;
  }
  Extent operator()(const CornerPiece& piece) const { return {piece.point, piece.point}; }
  Extent operator()(const RoundPiece& piece) const {
    Extent extent;
    add_circle(extent, piece.origin, piece.axis, piece.radius, piece.height);
    add_circle(extent, piece.origin, piece.axis, piece.radius + piece.length * piece.along_radius,
               piece.height + piece.length * piece.along_height);
    return extent;
  }
  Extent operator()(const RimPiece& piece) const {
    Extent extent;
    add_circle(extent, piece.origin, piece.axis, piece.radius, piece.height);
    return extent;
  }
};

}  // namespace

bool Shape::touch(std::int32_t piece, const Vec3& p, double reach, std::int8_t& on_side, Touch& at) const {
  return std::visit(Toucher{slabs, p, reach, on_side, at}, pieces[piece]);
}

std::int8_t Shape::side_of(std::int32_t piece, const Vec3& p) const { return std::visit(SideOf{p}, pieces[piece]); }

double Shape::distance(std::int32_t piece, const Vec3& p) const { return std::visit(Distance{p}, pieces[piece]); }

bool Shape::allows(const Vec3& p) const {
  if (side == Side::both) return true;
  return (encloses ? encloses(p) : covered(p)) == (side == Side::inside);
}

bool Shape::covered(const Vec3& p) const {
  bool odd = false;
  tree_.for_each_below(p, [&](std::int32_t index) {
    const auto* piece = std::get_if<TrianglePiece>(&pieces[index]);
    if (!piece) return;
    // Crossings of the triangle's sides, seen from above, with a line through p: each point of the plane is in one
    // triangle of a surface without gaps, those on sides included.
    bool inside = false;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = piece->corner[k], &b = piece->corner[(k + 1) % 3];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      const Vec3 &low = a.y() < b.y() ? a : b, &high = a.y() < b.y() ? b : a;
      const double x = low.x() + (p.y() - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
      inside = inside != (x > p.x());
    }
    if (!inside) return;
    const double below = signed_distance(*piece, p) / piece->normal.z();
    if (below > 0) odd = !odd;
  });
  return odd;
}

void Shape::finish() {
  std::vector<Extent> extents;
  extents.reserve(pieces.size());
  for (const Piece& piece : pieces) extents.push_back(std::visit(ExtentOf{}, piece));
  tree_.build(extents);
}

}  // namespace packstone::engine
