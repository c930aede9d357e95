// Packings with forces known by hand.
#pragma once

#include "tests/analysis/fixtures.hpp"

namespace packstone::fixtures {

/// A contact with a force f n + t between rows first and second over the nearest image, or with the boundary -1 -
/// second.
inline void add_contact(Snapshot& s, std::size_t first, std::int64_t second, const Vec3& normal, double normal_force,
                        const Vec3& tangential = Vec3::Zero()) {
  if (!s.contacts) s.contacts = Contacts{};
  Contacts& c = *s.contacts;
  c.first.push_back(s.id[first]);
  c.second.push_back(second >= 0 ? s.id[static_cast<std::size_t>(second)] : second);
  c.force.push_back(normal_force * normal + tangential);
  c.normal.push_back(normal);
  c.overlap.push_back(1e-9);
  c.point.push_back(s.position[first] - s.radius[first] * normal);
  c.sliding.push_back(0);
}

/// A central force between two particles, pressing positive.
inline void press(Snapshot& s, std::size_t first, std::size_t second, double force) {
  const Vec3 d = s.domain.separation(s.position[first], s.position[second]);
  add_contact(s, first, static_cast<std::int64_t>(second), d.normalized(), force);
}

/// A floor at z = 0 as boundary 0.
inline void add_floor(Snapshot& s) { s.boundaries.push_back({"floor", "plane", Vec3::Zero(), Vec3::UnitZ()}); }

/// n spheres of radius 1 on each other in a box of 4 x 4, on a floor, under their own weight and a load on the topmost
/// (a boundary above it); rows from the lowest up. Contacts carry what lies above them.
inline Snapshot column(int n, double load = 0) {
  Snapshot s = empty_box(Vec3(4, 4, 2.0 * n), {false, false, false});
  for (int k = 0; k < n; ++k) add_particle(s, Vec3(2, 2, 2 * k + 1), 1);
  add_floor(s);
  s.boundaries.push_back({"lid", "plane", Vec3(0, 0, 2.0 * n), -Vec3::UnitZ()});
  const double weight = s.mass(0) * 9.8;
  add_contact(s, 0, -1, Vec3::UnitZ(), n * weight + load);
  for (int k = 1; k < n; ++k)
    press(s, static_cast<std::size_t>(k), static_cast<std::size_t>(k - 1), (n - k) * weight + load);
  if (load > 0) add_contact(s, static_cast<std::size_t>(n) - 1, -2, -Vec3::UnitZ(), load);
  return s;
}

/// Column of a table by its name.
inline std::vector<double> table_column(const analysis::MeasureResult& result, const std::string& key,
                                        const std::string& name) {
  const analysis::Table& table = *result.table(key);
  std::vector<double> values;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].name != name) continue;
    for (const auto& row : table.rows) values.push_back(row[c]);
  }
  return values;
}

}  // namespace packstone::fixtures
