#include "core/bed_frame.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace packstone {

namespace {

constexpr double upright = 1 - 1e-9;  // least component along up of a floor's normal, or of an axis

double floor_coordinate(const Snapshot& snapshot, int axis, double sign) {
  double highest = sign > 0 ? snapshot.domain.min[axis] : -snapshot.domain.max[axis];
  bool found = false;
  for (const auto& boundary : snapshot.boundaries) {
    if (!(sign * boundary.normal[axis] >= upright)) continue;
    const double height = sign * boundary.point[axis];
    highest = found ? std::max(highest, height) : height;
    found = true;
  }
  return sign * highest;
}

double smallest_cross_section(const Snapshot& snapshot, int axis) {
  const Vec3 size = snapshot.domain.size();
  double area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  for (const auto& boundary : snapshot.boundaries) {
    const bool along_up = std::abs(boundary.axis[axis]) >= upright;
    if (along_up && boundary.cross_section > 0) area = std::min(area, boundary.cross_section);
  }
  return area;
}

}  // namespace

double BedFrame::top(const std::vector<double>& radius) const {
  double highest = 0;
  for (std::size_t i = 0; i < radius.size(); ++i) highest = std::max(highest, height[i] + radius[i]);
  return highest;
}

BedFrame bed_frame(const Snapshot& snapshot) {
  BedFrame frame;
  if (!snapshot.gravity.isZero(0)) snapshot.gravity.cwiseAbs().maxCoeff(&frame.axis);
  frame.sign = snapshot.gravity[frame.axis] > 0 ? -1 : 1;

  const Vec3 size = snapshot.domain.size();
  frame.area = smallest_cross_section(snapshot, frame.axis);
  frame.extent = size[frame.axis];
  if (!(size.minCoeff() > 0) || !size.allFinite()) {
    throw InputError("the domain is " + std::to_string(size.x()) + " x " + std::to_string(size.y()) + " x " +
                     std::to_string(size.z()) + " m; every side must be above 0 to measure the packing in it");
  }
  frame.periodic = snapshot.domain.periodic[frame.axis];
  if (frame.periodic) {
    frame.floor = frame.sign > 0 ? snapshot.domain.min[frame.axis] : snapshot.domain.max[frame.axis];
  } else {
    frame.floor = floor_coordinate(snapshot, frame.axis, frame.sign);
  }
  frame.height.reserve(snapshot.size());
  for (const auto& p : snapshot.position) frame.height.push_back(frame.sign * (p[frame.axis] - frame.floor));
  return frame;
}

}  // namespace packstone
