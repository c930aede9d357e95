#include "viz/slice_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/units.hpp"
#include "viz/container.hpp"
#include "viz/quantity.hpp"

namespace packstone::viz {

namespace {

const std::string through = "through ", normal_word = " normal ";

[[noreturn]] void refuse_plane(const std::string& text) {
  throw InputError(
      fmt::format("'{}' is not a plane; 'z=0.1', 'y=290 mm' or 'through 0.1,0.1,0.2 normal 1,1,0' would be", text));
}

}  // namespace

PlaneAxes axes_in_plane(int axis) {
  constexpr PlaneAxes axes[] = {{1, 2}, {0, 2}, {0, 1}};
  return axes[axis];
}

SlicePlane::SlicePlane(int across, double at)
    : axis(across),
      normal(Vec3::Unit(across)),
      position(at),
      right(Vec3::Unit(axes_in_plane(across).u)),
      up(Vec3::Unit(axes_in_plane(across).v)) {}

SlicePlane::SlicePlane(const Vec3& point, const Vec3& across) : normal(across.normalized()), origin(point) {
  if (!point.allFinite() || !(across.norm() > 0) || !across.allFinite()) {
    throw InputError("a slice's plane has a point and a normal of some length");
  }
  constexpr double level = 0.99;  // of the normal along z
  const Vec3 upward = std::abs(normal.z()) > level ? Vec3::UnitY() : Vec3::UnitZ();
  up = (upward - upward.dot(normal) * normal).normalized();
  right = up.cross(normal);
  // Seen from the side from which coordinates grow to the right.
  Eigen::Index main = 0;
  right.cwiseAbs().maxCoeff(&main);
  if (right[main] < 0) right = -right;
  position = normal.dot(point);
}

SlicePlane plane_from_text(const std::string& text) {
  if (text.starts_with(through)) {
    const std::size_t second = text.find(normal_word);
    if (second == std::string::npos) refuse_plane(text);
    const auto point = parse_vector(text.substr(through.size(), second - through.size()), unit::metre);
    const auto normal = parse_vector(text.substr(second + normal_word.size()), unit::none);
    if (!point || !normal) refuse_plane(text);
    return {*point, *normal};
  }
  const std::size_t equals = text.find('=');
  const std::size_t name = text.find_first_not_of(' ');
  for (int axis = 0; axis < 3; ++axis) {
    if (equals == std::string::npos || text.substr(name, equals - name).find(axis_names[axis]) != 0) continue;
    if (text.find_first_not_of(' ', name + 1) != equals) continue;
    const std::size_t value = text.find_first_not_of(' ', equals + 1);
    if (value == std::string::npos) continue;
    return {axis, parse_quantity(text.substr(value), unit::metre)};
  }
  refuse_plane(text);
}

std::string plane_text(const SlicePlane& plane) {
  if (plane.axis) return fmt::format("{} = {}", axis_names[*plane.axis], length_text(plane.position));
  return through_text(plane) + ", " + normal_text(plane);
}

std::string through_text(const SlicePlane& plane) {
  constexpr int digits = 3;
  const double longest = plane.origin.cwiseAbs().maxCoeff();
  const ReadableUnit unit = longest > 0 ? length_unit(longest) : ReadableUnit{"m", 1};
  return fmt::format("through {} {}", vector_text(plane.origin / unit.scale, digits), unit.name);
}

std::string normal_text(const SlicePlane& plane) {
  constexpr int digits = 3;
  return "normal " + vector_text(plane.normal, digits);
}

std::string vector_text(const Vec3& vector, int digits) {
  constexpr double round_off = 1e-12;  // of the longest component
  const double least = round_off * vector.cwiseAbs().maxCoeff();
  const auto clean = [&](double value) { return std::abs(value) <= least ? 0.0 : value; };
  return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", clean(vector.x()), digits, clean(vector.y()), digits,
                     clean(vector.z()), digits);
}

std::vector<InPlane> section(const Domain& domain, const SlicePlane& plane) {
  if (plane.axis) {
    const int k = *plane.axis;
    if (!(plane.position >= domain.min[k] && plane.position <= domain.max[k])) return {};
    const InPlane low = plane.place(domain.min), high = plane.place(domain.max);
    return {low, {high.u, low.v}, high, {low.u, high.v}};
  }
  std::vector<InPlane> corners;
  for (const Vec3& p : plane_in_box(plane.position * plane.normal, plane.normal, domain.min, domain.max)) {
    corners.push_back(plane.place(p));
  }
  return corners;
}

double distance_from(const std::vector<InPlane>& polygon, const InPlane& place) {
  double nearest = std::numeric_limits<double>::infinity();
  int turns = 0;  // to the left and to the right along the sides: all the same way inside
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const InPlane &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double du = b.u - a.u, dv = b.v - a.v, pu = place.u - a.u, pv = place.v - a.v;
    turns += du * pv - dv * pu >= 0 ? 1 : -1;
    const double share = std::clamp((pu * du + pv * dv) / (du * du + dv * dv), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(pu - share * du, pv - share * dv));
  }
  return std::abs(turns) == static_cast<int>(polygon.size()) ? 0 : nearest;
}

}  // namespace packstone::viz
