// Particles at independent random places, and a box of triangles.
#pragma once

#include "tests/analysis/fixtures.hpp"

namespace packstone::fixtures {

/// Independent uniform positions, every other particle of type 1.
inline Snapshot ideal_gas(std::size_t count, const Vec3& size, std::array<bool, 3> periodic, std::uint64_t seed,
                          double radius = 0.5) {
  Snapshot s = empty_box(size, periodic);
  Random random(seed, RandomStream::filling_position, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 share(random.uniform(), random.uniform(), random.uniform());
    add_particle(s, share.cwiseProduct(size), radius, static_cast<int>(i % 2));
  }
  return s;
}

/// Uniform over the directions.
inline Vec3 random_direction(Random& random) {
  const double z = random.uniform(-1, 1), phi = random.uniform(0, 2 * EIGEN_PI);
  const double across = std::sqrt(1 - z * z);
  return Vec3(across * std::cos(phi), across * std::sin(phi), z);
}

/// An upright prism of n equal facets around an axis through a point, corners at the radius, open at both ends.
inline BoundaryRecord prism(int n, const Vec3& centre, double radius, double low, double high) {
  BoundaryRecord record{"prism", "cylinder"};
  for (int k = 0; k < n; ++k) {
    const double phi = 2 * EIGEN_PI * k / n;
    for (const double z : {low, high}) {
      record.points.push_back(Vec3(centre.x() + radius * std::cos(phi), centre.y() + radius * std::sin(phi), z));
    }
    const int next = (k + 1) % n;
    record.triangles.push_back({2 * k, 2 * k + 1, 2 * next});
    record.triangles.push_back({2 * next, 2 * k + 1, 2 * next + 1});
  }
  return record;
}

}  // namespace packstone::fixtures
