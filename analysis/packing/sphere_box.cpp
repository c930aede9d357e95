#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/packing/overlap_volume.hpp"
#include "core/geometry.hpp"

namespace packstone::analysis {

namespace {

using std::numbers::pi;

/// Of the unit sphere beyond a plane at a signed distance from its centre.
double beyond(double a) { return sphere_volume_below(1, -a); }

/// What two perpendicular planes at distances a, b >= 0 of the unit sphere's centre have in common inside it; all 0
/// where they meet outside.
struct Edge {
  double a, b;
  double half_length = 0;  // of their common line inside the sphere
  double turn = 0;         // pi less the angle by which the outline of the common part turns at its ends
  double arc_a = 0;        // half of the circle in plane a that lies beyond b, and the other way round
  double arc_b = 0;

  Edge(double distance_a, double distance_b) : a(distance_a), b(distance_b) {
    const double squared = 1 - a * a - b * b;
    if (!(squared > 0)) return;
    half_length = std::sqrt(squared);
    turn = std::atan2(half_length, a * b);
    arc_a = std::atan2(half_length, b);
    arc_b = std::atan2(half_length, a);
  }
};

/// What the disc and the rim in a plane at distance a contribute, by the angle of its arc.
double weight(double a) { return a - a * a * a / 3; }

/// Beyond both planes of an edge.
double wedge(const Edge& e) {
  return 2.0 / 3 * (e.turn + e.a * e.b * e.half_length) - weight(e.a) * e.arc_a - weight(e.b) * e.arc_b;
}

/// Beyond three planes, a, b, c >= 0, from the edges that they make.
double corner(const Edge& ab, const Edge& bc, const Edge& ca) {
  const double a = ab.a, b = bc.a, c = ca.a;
  if (!(a * a + b * b + c * c < 1)) return 0;
  double sum = -pi - 3 * a * b * c;
  for (const Edge* e : {&ab, &bc, &ca}) sum += e->turn + e->a * e->b * e->half_length;
  return sum / 3 - 0.5 * (weight(a) * (ab.arc_a + ca.arc_b - pi / 2) + weight(b) * (bc.arc_a + ab.arc_b - pi / 2) +
                          weight(c) * (ca.arc_a + bc.arc_b - pi / 2));
}

/// Beyond two planes at signed distances, from the edge of their mirror images on the positive side.
double signed_wedge(double a, double b, const Edge& e) {
  const double first = wedge(e);
  if (a >= 0) return b >= 0 ? first : beyond(a) - first;
  return b >= 0 ? beyond(b) - first : beyond(b) - (beyond(-a) - first);
}

/// Beyond three planes at signed distances, none of which misses the unit sphere.
double signed_corner(double a, double b, double c) {
  const double u = std::abs(a), v = std::abs(b), w = std::abs(c);
  const Edge ab(u, v), bc(v, w), ca(w, u);
  double volume = corner(ab, bc, ca);
  // Each negative distance takes the mirror image off what lies beyond the other two.
  if (a < 0) volume = wedge(bc) - volume;
  if (b < 0) volume = signed_wedge(w, a, ca) - volume;
  if (c < 0) volume = signed_wedge(a, b, ab) - volume;
  return volume;
}

}  // namespace

double sphere_corner_volume(double radius, const Vec3& upper) {
  if (!(radius > 0)) return 0;
  // The part below is the part beyond of the sphere turned about its centre.
  const Vec3 distance = -upper / radius;
  if (distance.maxCoeff() >= 1) return 0;
  double cut[3];
  int cuts = 0;
  for (int k = 0; k < 3; ++k) {
    if (distance[k] > -1) cut[cuts++] = distance[k];
  }
  double volume = sphere_volume(1);
  if (cuts == 1) volume = beyond(cut[0]);
  if (cuts == 2) volume = signed_wedge(cut[0], cut[1], Edge(std::abs(cut[0]), std::abs(cut[1])));
  if (cuts == 3) volume = signed_corner(cut[0], cut[1], cut[2]);
  return std::max(0.0, volume) * radius * radius * radius;
}

double sphere_box_volume(const Vec3& centre, double radius, const Vec3& min, const Vec3& max) {
  if (!(radius > 0) || !((max - min).minCoeff() > 0)) return 0;
  const Vec3 low = min - centre, high = max - centre;
  if (low.maxCoeff() >= radius || high.minCoeff() <= -radius) return 0;
  if (low.cwiseAbs().cwiseMax(high.cwiseAbs()).squaredNorm() <= radius * radius) return (max - min).prod();
  double volume = 0;
  for (int k = 0; k < 8; ++k) {
    const bool x = k & 1, y = k & 2, z = k & 4;
    const double sign = (x + y + z) % 2 == 1 ? 1 : -1;
    volume +=
        sign * sphere_corner_volume(radius, {x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z()});
  }
  return std::clamp(volume, 0.0, std::min(sphere_volume(radius), (max - min).prod()));
}

}  // namespace packstone::analysis
