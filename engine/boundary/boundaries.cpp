#include "engine/boundary/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/boundary_options.hpp"
#include "core/error.hpp"
#include "engine/boundary/make_shape.hpp"

namespace packstone::engine {

namespace {

/// About which a boundary turns unless the scene says otherwise.
Vec3 point_of(const BoundarySpec& b) {
  if (b.point) return *b.point;
  if (b.min) return 0.5 * (*b.min + *b.max);
  return b.offset.value_or(Vec3::Zero());
}

}  // namespace

Boundaries::Boundaries(const Scene& scene, const Domain& domain) : specs_(scene.boundaries), domain_(domain) {
  if (!scene.stages.empty()) stage_ = scene.stages.front().name;
  for (std::size_t k = 0; k < specs_.size(); ++k) {
    const BoundarySpec& spec = specs_[k];
    Body body;
    body.shape = make_shape(scene, k, domain);
    body.material = scene.material_index(spec.material);
    body.present = is_there(spec, 0);
    if (spec.motion.present) {
      body.motion.emplace(scene, k, point_of(spec));
      body.pose = body.motion->at(0);
      body.moves = true;
    }
    bodies_.push_back(std::move(body));
  }
}

double Boundaries::farthest_point(const Body& body) const {
  const Vec3 middle = body.pose.centre + body.pose.shift;
  const Extent& extent = body.shape.extent();
  if (extent.low.allFinite() && extent.high.allFinite()) {
    return (body.pose.centre - extent.low).cwiseAbs().cwiseMax((body.pose.centre - extent.high).cwiseAbs()).norm();
  }
  return (middle - domain_.min).cwiseAbs().cwiseMax((middle - domain_.max).cwiseAbs()).norm();
}

bool Boundaries::is_there(const BoundarySpec& spec, double time) const {
  const bool in_stage = spec.stages.empty() || std::count(spec.stages.begin(), spec.stages.end(), stage_) > 0;
  return in_stage && time >= spec.from && (!spec.until || time < *spec.until);
}

void Boundaries::begin_stage(const std::string& stage, double time) {
  stage_ = stage;
  for (Body& body : bodies_) {
    if (body.motion) body.motion->begin_stage(stage, time);
  }
}

void Boundaries::go_to(double time, double dt, double velocity_lead) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Body& body = bodies_[k];
    body.present = is_there(specs_[k], time);
    if (!body.moves) continue;
    body.pose = body.motion->at(time);
    PoseRate last = body.motion->rate(time - dt, time);
    body.rate = velocity_lead > 0 ? body.motion->rate(time - dt, time + dt) : last;
    if (specs_[k].motion.free) {
      const Vec3 axis = specs_[k].motion.free_axis.normalized();
      body.pose.shift += body.travel * axis;
      last.velocity += body.half_speed * axis;
      body.rate.velocity += (body.half_speed + velocity_lead * body.acceleration) * axis;
    }
    body.speed = last.velocity.norm() + last.angular_velocity.norm() * farthest_point(body);
    body.travelled += dt * body.speed;
  }
}

void Boundaries::push(const std::vector<WallLoad>& loads, const Vec3& gravity, double time, double dt) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const MotionSpec& spec = specs_[k].motion;
    if (!spec.free) continue;
    Body& body = bodies_[k];
    if (!body.present || !body.motion->moves(time)) {
      body.half_speed = body.acceleration = 0;
      continue;
    }
    const Vec3 axis = spec.free_axis.normalized();
    body.acceleration = (loads[k].force.dot(axis) + body.motion->force(time)) / spec.mass + gravity.dot(axis);
    body.half_speed += dt * body.acceleration;
    body.travel += dt * body.half_speed;
    if (spec.limit && body.travel > *spec.limit) {
      body.travel = *spec.limit;
      body.half_speed = body.acceleration = 0;
    }
  }
}

bool Boundaries::along_periodic_axes(int shift) const {
  const Vec3 vector = shift_vector(shift);
  for (int axis = 0; axis < 3; ++axis) {
    if (vector[axis] != 0 && !domain_.periodic[axis]) return false;
  }
  return true;
}

bool Boundaries::leave_room(const Vec3& p, double reach) const {
  for (const Body& body : bodies_) {
    if (!body.present) continue;
    bool near = false;
    for_each_image(body, p, [&](const Vec3& image, int) {
      body.shape.for_each_near(body.inside(image), reach, [&](std::int32_t) { near = true; });
    });
    if (near || !body.shape.allows(body.inside(p))) return false;
  }
  return true;
}

std::optional<std::size_t> Boundaries::plane_before(const Vec3& p) const {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Body& body = bodies_[k];
    if (body.present && body.shape.is_plane() && body.shape.distance(0, body.inside(p)) <= 0) return k;
  }
  return std::nullopt;
}

void Boundaries::archive(Archive& a) {
  a(stage_);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Body& body = bodies_[k];
    const std::uint64_t pieces = body.shape.pieces.size();
    std::uint64_t pieces_then = pieces;
    a(pieces_then);
    if (pieces_then != pieces) {
      throw InputError(
          fmt::format("the surface of boundary \"{}\" has {} pieces, but had {} when the run was stopped; "
                      "its file has changed",
                      specs_[k].name, pieces, pieces_then));
    }
    a(body.present, body.pose, body.rate, body.travelled, body.speed, body.travel, body.half_speed, body.acceleration);
    if (body.motion) a(*body.motion);
  }
}

std::vector<BoundaryRecord> Boundaries::records() const {
  std::vector<BoundaryRecord> all;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Body& body = bodies_[k];
    if (!body.present) {
      all.push_back({});
    } else {
      all.push_back(body.shape.record);
      BoundaryRecord& record = all.back();
      for (Vec3& p : record.points) p = body.pose(p);
      record.point = body.pose(record.point);
      record.normal = body.pose.turn * record.normal;
      record.axis = body.pose.turn * record.axis;
    }
    all.back().name = specs_[k].name;
    all.back().kind = kind_name(specs_[k].kind);
  }
  return all;
}

}  // namespace packstone::engine
