// What the tests of measure "voronoi" share: its table of cells, random packings, boundaries as the engine records
// them.
#pragma once

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "tests/analysis/fixtures.hpp"

namespace packstone::fixtures {

using std::numbers::pi;

/// Columns of table "cells".
enum Column { id_column, type_column, volume_column, fraction_column, faces_column, state_column };

inline analysis::MeasureResult voronoi(const Snapshot& s) { return measured(s, "voronoi", {.voronoi_cells = true}); }

inline std::vector<double> column(const analysis::MeasureResult& result, Column c) {
  std::vector<double> values;
  for (const auto& row : result.table("cells")->rows) values.push_back(row[c]);
  return values;
}

/// Spheres at random places of the domain, radii between smallest and 1.
inline void fill_at_random(Snapshot& s, int count, double smallest, std::uint64_t seed) {
  for (int i = 0; i < count; ++i) {
    Random random(seed, RandomStream::filling_position, static_cast<std::uint64_t>(i));
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = random.uniform(s.domain.min[k], s.domain.max[k]);
    add_particle(s, p, random.uniform(smallest, 1.0), i % 2);
  }
}

/// The spheres of one packing in the domain and boundaries of another, where a condition holds.
template <class Inside>
Snapshot taken_from(const Snapshot& packing, Snapshot into, Inside&& inside) {
  for (std::size_t i = 0; i < packing.size(); ++i) {
    if (inside(packing.position[i])) add_particle(into, packing.position[i], packing.radius[i]);
  }
  return into;
}

inline void check_filled(const analysis::MeasureResult& result, double volume) {
  CHECK(value(result, "container_volume") == Approx(volume).epsilon(1e-12));
  CHECK(std::abs(value(result, "volume_error")) < 1e-12);
  CHECK(result.quantity("volume_error")->note.empty());
}

/// A box of six faces, as the engine records it.
inline BoundaryRecord box_record(const Vec3& min, const Vec3& max) {
  BoundaryRecord box{"bin", "box"};
  for (int corner = 0; corner < 8; ++corner) {
    box.points.push_back(
        {corner & 1 ? max.x() : min.x(), corner & 2 ? max.y() : min.y(), corner & 4 ? max.z() : min.z()});
  }
  box.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}, {0, 2, 4}, {2, 6, 4},
                   {1, 5, 3}, {3, 5, 7}, {0, 4, 1}, {1, 4, 5}, {2, 3, 6}, {3, 7, 6}};
  return box;
}

/// An upright cylinder with a closed lower end, in facets as the engine records it.
inline BoundaryRecord cylinder_record(const Vec3& bottom, double radius, double length, int facets = 96) {
  BoundaryRecord record{"can", "cylinder", bottom, Vec3::UnitZ(), Vec3::UnitZ(), pi * radius * radius};
  const double rings[][2] = {{0, 0}, {radius, 0}, {radius, length}};
  for (const auto& [r, height] : rings) {
    for (int k = 0; k < facets; ++k) {
      const double angle = 2 * pi * k / facets;
      record.points.push_back(bottom + Vec3(r * std::cos(angle), r * std::sin(angle), height));
    }
  }
  for (int ring = 0; ring < 2; ++ring) {
    for (int k = 0; k < facets; ++k) {
      const int a = ring * facets + k, b = ring * facets + (k + 1) % facets;
      if (ring > 0) record.triangles.push_back({a, a + facets, b});
      record.triangles.push_back({b, a + facets, b + facets});
    }
  }
  return record;
}

}  // namespace packstone::fixtures
