#include "core/formats/particle_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/geometry.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

constexpr double most_types = 10000;                  ///< kinds of particles, not a number for each
constexpr double largest_whole = 9007199254740992.0;  ///< 2^53: beyond it doubles skip whole numbers

const std::map<std::string, KnownColumn, std::less<>> aliases = {{"diameter", {"radius", 0.5}},
                                                                 {"r", {"radius"}},
                                                                 {"radii", {"radius"}},
                                                                 {"rad", {"radius"}},
                                                                 {"group", {"type"}},
                                                                 {"matId", {"type"}},
                                                                 {"materialId", {"type"}},
                                                                 {"omegax", {"wx"}},
                                                                 {"omegay", {"wy"}},
                                                                 {"omegaz", {"wz"}},
                                                                 {"ID", {"id"}},
                                                                 {"particle_id", {"id"}},
                                                                 {"velocity_x", {"vx"}},
                                                                 {"velocity_y", {"vy"}},
                                                                 {"velocity_z", {"vz"}},
                                                                 {"force_x", {"fx"}},
                                                                 {"force_y", {"fy"}},
                                                                 {"force_z", {"fz"}}};

struct VectorField {
  const char* name;
  const char* unit;
  std::array<const char*, 3> columns;
};

constexpr std::array vector_fields = {VectorField{"velocity", "m/s", {"vx", "vy", "vz"}},
                                      VectorField{"angular_velocity", "rad/s", {"wx", "wy", "wz"}},
                                      VectorField{"force", "N", {"fx", "fy", "fz"}}};

/// Moves a column out; empty where there is none.
std::vector<double> taken(ParticleColumns& columns, std::string_view name) {
  const auto found = columns.values.find(name);
  if (found == columns.values.end()) return {};
  std::vector<double> values = std::move(found->second);
  columns.values.erase(found);
  return values;
}

void check_needed(const ParticleColumns& columns) {
  for (const char* needed : {"x", "y", "z"}) {
    if (!columns.has(needed)) {
      throw InputError(
          fmt::format("{}: has no positions (column {}); a packing needs x, y, z and radius", columns.source, needed));
    }
  }
  if (!columns.has("radius")) {
    throw InputError(columns.source +
                     ": has no radii; let the program write a column radius or diameter beside the positions");
  }
}

/// A particle without size, as while radii grow, may have no mass.
void check_positive(const ParticleColumns& columns, const char* name, const char* unit, const Snapshot& s) {
  const auto found = columns.values.find(name);
  if (found == columns.values.end()) return;
  for (std::size_t i = 0; i < columns.count; ++i) {
    const double value = found->second[i];
    const bool nothing = value == 0 && s.radius[i] == 0;
    if (!nothing && (!(value > 0) || !std::isfinite(value))) {
      columns.fail(i, fmt::format("{}: {:g} {} is out of range; it must be greater than 0", name, value, unit));
    }
  }
}

/// A whole number that a double holds exactly.
std::int64_t whole(const ParticleColumns& columns, const char* name, std::size_t row, double value) {
  if (std::trunc(value) != value || !(std::abs(value) <= largest_whole)) {
    columns.fail(row, fmt::format("{}: {:.17g} is not a whole number", name, value));
  }
  return static_cast<std::int64_t>(value);
}

void place_spheres(ParticleColumns& columns, Snapshot& s) {
  const std::vector<double> x = taken(columns, "x"), y = taken(columns, "y"), z = taken(columns, "z");
  s.radius = taken(columns, "radius");
  s.position.resize(columns.count);
  for (std::size_t i = 0; i < columns.count; ++i) {
    s.position[i] = Vec3(x[i], y[i], z[i]);
    if (!s.position[i].allFinite()) columns.fail(i, "x, y, z: the position is not finite");
    if (!(s.radius[i] >= 0) || !std::isfinite(s.radius[i])) {
      columns.fail(i, fmt::format("radius: {:g} m is out of range; it must be 0 or above", s.radius[i]));
    }
  }
}

void set_ids(ParticleColumns& columns, Snapshot& s) {
  const std::vector<double> ids = taken(columns, "id");
  s.id.resize(columns.count);
  if (ids.empty()) std::iota(s.id.begin(), s.id.end(), std::int64_t{0});
  for (std::size_t i = 0; i < ids.size(); ++i) {
    s.id[i] = whole(columns, "id", i, ids[i]);
    if (s.id[i] < 0) columns.fail(i, fmt::format("id: {} is negative; ids count from 0 or 1", s.id[i]));
  }
}

void set_groups(ParticleColumns& columns, Snapshot& s) {
  const std::vector<double> types = taken(columns, "type");
  s.type.assign(columns.count, 0);
  std::size_t groups = columns.count > 0 ? 1 : 0;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const double index = static_cast<double>(whole(columns, "type", i, types[i]) - columns.first_type);
    if (index < 0 || index >= most_types) {
      columns.fail(i, fmt::format("type: {:.17g} is out of range; types go from {} to {}", types[i], columns.first_type,
                                  columns.first_type + static_cast<std::int64_t>(most_types) - 1));
    }
    s.type[i] = static_cast<std::int32_t>(index);
    groups = std::max(groups, static_cast<std::size_t>(index) + 1);
  }
  for (std::size_t g = 0; g < groups; ++g) {
    const std::string name = g < columns.type_names.size()
                                 ? columns.type_names[g]
                                 : fmt::format("type {}", columns.first_type + static_cast<std::int64_t>(g));
    s.groups.push_back({name, name, 0});
    s.material_names.push_back(name);
  }
  s.material = s.type;
}

/// Of every group mass over volume: a program that prints few digits of a mass gives each particle a little another
/// density.
void set_densities(ParticleColumns& columns, Snapshot& s) {
  check_positive(columns, "density", "kg/m3", s);
  check_positive(columns, "mass", "kg", s);
  const std::vector<double> density = taken(columns, "density");
  if (columns.has("mass")) s.fields["mass"] = {1, "kg", taken(columns, "mass")};
  if (density.empty() && s.fields.count("mass") == 0) {
    columns.notes.emplace_back(note_no_density);
    return;
  }
  struct Sums {
    double mass = 0, volume = 0, first_density = 0;
    bool uniform = true;
  };
  std::vector<Sums> sums(s.groups.size());
  for (std::size_t i = 0; i < columns.count; ++i) {
    Sums& sum = sums[static_cast<std::size_t>(s.type[i])];
    const double volume = sphere_volume(s.radius[i]);
    sum.volume += volume;
    sum.mass += density.empty() ? s.fields["mass"].values[i] : density[i] * volume;
    if (density.empty()) continue;
    if (sum.first_density == 0) sum.first_density = density[i];
    sum.uniform = sum.uniform && density[i] == sum.first_density;
  }
  for (std::size_t g = 0; g < sums.size(); ++g) {
    const bool as_written = !density.empty() && sums[g].uniform;
    if (sums[g].volume > 0) s.groups[g].density = as_written ? sums[g].first_density : sums[g].mass / sums[g].volume;
  }
}

void set_fields(ParticleColumns& columns, Snapshot& s) {
  for (const VectorField& wanted : vector_fields) {
    std::array<std::vector<double>, 3> parts;
    for (int k = 0; k < 3; ++k) parts[k] = taken(columns, wanted.columns[k]);
    if (parts[0].empty() && parts[1].empty() && parts[2].empty()) continue;
    Field field{3, wanted.unit, std::vector<double>(3 * columns.count, 0.0)};
    for (int k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < parts[k].size(); ++i) field.values[3 * i + k] = parts[k][i];
    }
    s.fields[wanted.name] = std::move(field);
  }
  for (auto& [name, values] : columns.values) {
    std::string safe = name;
    std::replace(safe.begin(), safe.end(), '/', '_');  // which snapshots' files take for folders
    s.fields.emplace(safe, Field{1, "", std::move(values)});
  }
}

void set_domain(ParticleColumns& columns, Snapshot& s) {
  if (columns.domain) {
    s.domain = *columns.domain;
  } else if (s.size() > 0) {
    Vec3 low = s.position.front(), high = low;
    for (std::size_t i = 0; i < s.size(); ++i) {
      low = low.cwiseMin(Vec3(s.position[i].array() - s.radius[i]));
      high = high.cwiseMax(Vec3(s.position[i].array() + s.radius[i]));
    }
    s.domain = {low, high, {false, false, false}};
    columns.notes.emplace_back(note_no_box);
  }
  for (Vec3& p : s.position) p = s.domain.wrapped(p);
}

void check_ids(const ParticleColumns& columns, const Snapshot& s) {
  if (std::adjacent_find(s.id.begin(), s.id.end(), std::greater_equal<>()) == s.id.end()) return;
  const std::vector<std::size_t> order = id_order(s);
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (s.id[order[k - 1]] != s.id[order[k]]) continue;
    columns.fail(std::max(order[k - 1], order[k]),
                 fmt::format("id: {} occurs twice; each particle needs its own", s.id[order[k]]));
  }
}

/// Programs write particles as they lie in memory or by their ids, often far from those they touch.
void sort_in_space(Snapshot& s) {
  const std::vector<std::size_t> order = space_filling_order(s);
  if (!std::is_sorted(order.begin(), order.end())) s = with_rows(s, order);
}

}  // namespace

void ParticleColumns::fail(std::size_t row, const std::string& what) const {
  const std::int64_t at = !line.empty() ? line[row] : first_line + static_cast<std::int64_t>(row);
  if (line.empty() && first_line == 0) throw InputError(fmt::format("{}: particle {}: {}", source, row, what));
  throw InputError(fmt::format("{}:{}: {}", source, at, what));
}

KnownColumn known_column(const std::string& name) {
  const auto found = aliases.find(name);
  return found == aliases.end() ? KnownColumn{name} : found->second;
}

void add_column(ParticleColumns& columns, const std::string& name, std::vector<double>&& values) {
  const KnownColumn known = known_column(name);
  if (columns.has(known.name)) return;
  if (known.factor != 1) {
    for (double& value : values) value *= known.factor;
  }
  columns.values.emplace(known.name, std::move(values));
}

Snapshot to_snapshot(ParticleColumns&& columns) {
  check_needed(columns);
  Snapshot s;
  s.time = columns.time;
  s.step = columns.step;
  place_spheres(columns, s);
  set_ids(columns, s);
  check_ids(columns, s);
  set_groups(columns, s);
  set_densities(columns, s);
  set_fields(columns, s);
  set_domain(columns, s);
  sort_in_space(s);
  s.notes = std::move(columns.notes);
  return s;
}

}  // namespace packstone::formats
