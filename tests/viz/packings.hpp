// Small packings made by hand.
#pragma once

#include <cmath>

#include "core/snapshot.hpp"

namespace packstone::testing {

/// An empty box, periodic in x and y, on a floor; two groups.
inline Snapshot empty_box(const Vec3& size) {
  Snapshot snapshot;
  snapshot.time = 1.25;
  snapshot.domain.max = size;
  snapshot.domain.periodic = {true, true, false};
  snapshot.groups = {{"light", "glass", 1200}, {"heavy", "steel", 2400}};
  snapshot.material_names = {"glass", "steel"};
  snapshot.boundaries = {{"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}};
  return snapshot;
}

inline void add_particle(Snapshot& snapshot, const Vec3& position, double radius, int type) {
  snapshot.position.push_back(position);
  snapshot.radius.push_back(radius);
  snapshot.id.push_back(static_cast<std::int64_t>(snapshot.id.size()));
  snapshot.type.push_back(type);
  snapshot.material.push_back(type);
}

/// One sphere in the middle of a box that reaches over it.
inline Snapshot single_sphere(double radius) {
  Snapshot snapshot = empty_box(Vec3::Ones());
  snapshot.boundaries.clear();
  add_particle(snapshot, Vec3::Constant(0.5), radius, 0);
  return snapshot;
}

/// A cylinder that particles lie in, standing on its floor at the centre; 2 sides triangles of wall, 1 sides of floor.
/// Sides look along x and y where their number goes by 4.
inline BoundaryRecord upright_cylinder(const Vec3& centre, double radius, double height, int sides) {
  BoundaryRecord drum;
  drum.name = "drum";
  drum.kind = "cylinder";
  drum.points.push_back(centre);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * (i + 0.5) / sides;
    const Vec3 rim = centre + radius * Vec3(std::cos(angle), std::sin(angle), 0);
    drum.points.push_back(rim);
    drum.points.push_back(rim + height * Vec3::UnitZ());
    const int low = 2 * i + 1;
    const int next = 2 * ((i + 1) % sides) + 1;
    drum.triangles.push_back({low, next + 1, next});
    drum.triangles.push_back({low, low + 1, next + 1});
    drum.triangles.push_back({0, low, next});
  }
  return drum;
}

/// The same surface with corners of its own for every triangle, as in an STL file.
inline BoundaryRecord cut_apart(const BoundaryRecord& surface) {
  BoundaryRecord apart = surface;
  apart.points.clear();
  for (auto& triangle : apart.triangles) {
    for (auto& corner : triangle) {
      apart.points.push_back(surface.points[corner]);
      corner = static_cast<std::int32_t>(apart.points.size() - 1);
    }
  }
  return apart;
}

/// Shifted square layers, the lower half heavy, with all lengths in the given unit [m].
inline Snapshot layered_packing(double unit) {
  constexpr int side = 5;
  constexpr int layers = 7;
  constexpr double radius = 0.098;
  Snapshot snapshot = empty_box(unit * Vec3(1, 1, 1.6));
  Field velocity{3, "m/s", {}};
  for (int k = 0; k < layers; ++k) {
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const double shift = k % 2 == 0 ? 0.25 : 0.75;
        const Vec3 place((i + shift) / side, (j + shift) / side, radius + 0.145 * k);
        add_particle(snapshot, snapshot.domain.wrapped(unit * place), unit * radius, k < layers / 2 ? 1 : 0);
        velocity.values.insert(velocity.values.end(), {0.0, 0.3 * k, 0.4 * k});
      }
    }
  }
  snapshot.fields["velocity"] = velocity;
  return snapshot;
}

}  // namespace packstone::testing
