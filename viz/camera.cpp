#include "viz/camera.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <vtkCamera.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone::viz {

namespace {

const std::vector<std::string> view_names = {"iso", "front", "back", "left", "right", "top", "bottom"};

constexpr double degree = M_PI / 180;
constexpr Turn iso_turn = {32 * degree, 20 * degree};
constexpr double half_view_angle = 10 * degree;  ///< of the region's height, in perspective
constexpr double spare_depth = 1;                ///< before and behind the box, for particles that stick out

std::array<Vec3, 3> axes_of(const Turn& turn) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Vec3 level = std::sin(turn.azimuth) * x - std::cos(turn.azimuth) * y;
  const Vec3 right = std::cos(turn.azimuth) * x + std::sin(turn.azimuth) * y;
  return {right, std::cos(turn.elevation) * z - std::sin(turn.elevation) * level,
          std::cos(turn.elevation) * level + std::sin(turn.elevation) * z};
}

std::array<Vec3, 3> axes_of(View view) {
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  switch (view) {
    case View::front:
      return {x, z, -y};
    case View::back:
      return {-x, z, y};
    case View::left:
      return {-y, z, -x};
    case View::right:
      return {y, z, x};
    case View::top:
      return {x, y, z};
    case View::bottom:
      return {x, -y, -z};
    case View::iso:
      break;
  }
  return axes_of(iso_turn);
}

}  // namespace

View view_named(const std::string& name) {
  const auto found = std::find(view_names.begin(), view_names.end(), name);
  if (found == view_names.end()) {
    throw InputError(fmt::format("there is no view '{}'; there are {}, and AZIMUTH,ELEVATION in degrees, such as 32,20",
                                 name, joined(view_names)));
  }
  return static_cast<View>(found - view_names.begin());
}

Viewpoint viewpoint_from_text(const std::string& text) {
  double azimuth = 0, elevation = 0;
  int used = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%n", &azimuth, &elevation, &used) != 2) return view_named(text);
  constexpr double upright = 90;
  if (used != static_cast<int>(text.size()) || !std::isfinite(azimuth) || !(std::abs(elevation) <= upright)) {
    throw InputError(
        fmt::format("'{}' is no view: expected AZIMUTH,ELEVATION in degrees, the latter from -90 to 90, "
                    "such as 32,20",
                    text));
  }
  Viewpoint viewpoint;
  viewpoint.turn = Turn{azimuth * degree, elevation * degree};
  return viewpoint;
}

std::array<Vec3, 8> box_corners(const Vec3& min, const Vec3& max) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 3; ++k) corners[i][k] = (i >> k & 1) != 0 ? max[k] : min[k];
  }
  return corners;
}

Camera::Camera(const Viewpoint& viewpoint, const Vec3& min, const Vec3& max, const Box& region)
    : axes_(viewpoint.turn ? axes_of(*viewpoint.turn) : axes_of(viewpoint.view)),
      parallel_(!viewpoint.perspective()),
      centre_(region.centre()) {
  std::array<Vec3, 8> corners = box_corners(min, max);
  for (Vec3& corner : corners) corner = Vec3(axes_[0].dot(corner), axes_[1].dot(corner), axes_[2].dot(corner));
  const auto by_depth = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
  const auto [far, near] = std::minmax_element(corners.begin(), corners.end(), by_depth);
  nearest_ = near->z();
  farthest_ = far->z();
  if (parallel_) {
    fit_parallel(corners, region);
  } else {
    fit_perspective(corners, region);
  }
}

void Camera::fit_parallel(const std::array<Vec3, 8>& corners, const Box& region) {
  const double room[2] = {region.width(), region.height()};
  focal_ = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 2; ++k) {
    const auto by_place = [k](const Vec3& a, const Vec3& b) { return a[k] < b[k]; };
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end(), by_place);
    focal_ = std::min(focal_, room[k] / ((*high)[k] - (*low)[k]));
    at_[k] = ((*high)[k] + (*low)[k]) / 2;
  }
  at_.z() = nearest_ + 2 * spare_depth;
}

// A corner at (x, z) is inside the half angle of slope t, seen from (a, d), when |x - a| <= t (d - z). Over all corners
// that asks for d >= (max(x + t z) - min(x - t z)) / 2t, and a halfway between the two leaves equal room on both sides.
void Camera::fit_perspective(const std::array<Vec3, 8>& corners, const Box& region) {
  focal_ = region.height() / 2 / std::tan(half_view_angle);
  const double slopes[2] = {region.width() / 2 / focal_, region.height() / 2 / focal_};
  at_.z() = 0;
  for (int k = 0; k < 2; ++k) {
    double high = -std::numeric_limits<double>::infinity();
    double low = std::numeric_limits<double>::infinity();
    for (const Vec3& c : corners) {
      high = std::max(high, c[k] + slopes[k] * c.z());
      low = std::min(low, c[k] - slopes[k] * c.z());
    }
    at_.z() = std::max(at_.z(), (high - low) / (2 * slopes[k]));
    at_[k] = (high + low) / 2;
  }
}

void Camera::look_closer(double zoom, const std::optional<Vec3>& focus) {
  focal_ *= zoom;
  if (!focus) return;
  for (int k = 0; k < 2; ++k) at_[k] = axes_[k].dot(*focus);
}

Vec3 Camera::eye() const { return at_.x() * axes_[0] + at_.y() * axes_[1] + at_.z() * axes_[2]; }

Point Camera::project(const Vec3& p) const {
  const double scale = pixels_per_unit_at(p);
  return {centre_.x + scale * (axes_[0].dot(p) - at_.x()), centre_.y - scale * (axes_[1].dot(p) - at_.y())};
}

double Camera::pixels_per_unit_at(const Vec3& p) const { return parallel_ ? focal_ : focal_ / (at_.z() - height(p)); }

bool Camera::sees(const Vec3& point, const Vec3& normal) const {
  constexpr double edge_on = 1e-6;
  const Vec3 towards = parallel_ ? axes_[2] : Vec3((eye() - point).normalized());
  return towards.dot(normal) > edge_on;
}

void Camera::apply(vtkCamera& camera, int width, int height) const {
  const Vec3 from = eye();
  const Vec3 focus = from - axes_[2];
  camera.SetPosition(from.data());
  camera.SetFocalPoint(focus.data());
  camera.SetViewUp(axes_[1].data());
  const double half_height = height / 2.0 / focal_;
  camera.SetParallelProjection(parallel_);
  if (parallel_) {
    camera.SetParallelScale(half_height);
  } else {
    camera.SetViewAngle(2 * std::atan(half_height) / degree);
  }
  camera.SetWindowCenter(1 - 2 * centre_.x / width, 2 * centre_.y / height - 1);
  camera.SetClippingRange(nearest_distance(), farthest_distance());
}

Vec3 Camera::point_at(Point pixel, double distance) const {
  const double unit = (parallel_ ? 1 : distance) / focal_;
  return (at_.x() + (pixel.x - centre_.x) * unit) * axes_[0] + (at_.y() - (pixel.y - centre_.y) * unit) * axes_[1] +
         (at_.z() - distance) * axes_[2];
}

double Camera::nearest_distance() const {
  constexpr double nearest_share = 0.1;
  const double distance = at_.z() - nearest_;
  return std::max(distance * nearest_share, distance - spare_depth);
}

double Camera::farthest_distance() const { return at_.z() - farthest_ + spare_depth; }

Camera Camera::finer(int factor) const {
  Camera camera = *this;
  camera.centre_ = {centre_.x * factor, centre_.y * factor};
  camera.focal_ *= factor;
  return camera;
}

Camera Camera::of_part(Point corner) const {
  Camera camera = *this;
  camera.centre_ = {centre_.x - corner.x, centre_.y - corner.y};
  return camera;
}

}  // namespace packstone::viz
