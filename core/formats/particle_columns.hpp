// What the readers of other programs' files hand over: the particles column by column, before they are checked.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/domain.hpp"
#include "core/snapshot.hpp"

namespace packstone::formats {

/// Columns of a file by name, in SI units. These names mean something, whatever the file calls them:
/// x y z radius (needed), id, type, density, mass, vx vy vz, wx wy wz, fx fy fz. Any other becomes a scalar field.
struct ParticleColumns {
  std::string source;                                              ///< the file, for messages
  std::size_t count = 0;                                           ///< particles
  std::map<std::string, std::vector<double>, std::less<>> values;  ///< (N) each

  std::vector<std::int64_t> line;  ///< (N) where each stands in the file, counted from 1
  std::int64_t first_line = 0;     ///< instead, where they stand on successive lines; 0: the file has no lines

  std::int64_t first_type = 0;          ///< number of the first type
  std::vector<std::string> type_names;  ///< of the types from the first on; where short: "type NUMBER"

  std::optional<Domain> domain;  ///< the file's box
  double time = 0;               ///< [s]
  std::int64_t step = 0;
  std::vector<std::string> notes;  ///< what had to be assumed

  /// Throws InputError "FILE:LINE: what" at a particle, "FILE: particle ROW: what" in a file without lines.
  [[noreturn]] void fail(std::size_t row, const std::string& what) const;
  bool has(std::string_view name) const { return values.find(name) != values.end(); }
};

/// The name that a column has here, and the factor to its SI unit.
struct KnownColumn {
  std::string name;
  double factor = 1;
};

/// "diameter" is twice the radius, "omegax" is wx, "radii" is radius, ...; other names stay as they are.
KnownColumn known_column(const std::string& name);

/// Adds a column under the name it has here. A second column of the same name gives way to the first.
void add_column(ParticleColumns& columns, const std::string& name, std::vector<double>&& values);

/// Checks the particles, puts them into space_filling_order and groups them by type. Every type from the first up to
/// the largest is a group; its density is its mass over its volume where the file has either for all particles, else 0:
/// unknown. A file without a box has the spheres' bounding box, not periodic. Positions come inside along periodic
/// axes. Throws InputError where a needed column is missing, a position or a radius is not finite, a radius is
/// negative, a density or a mass is not positive, a type or an id is not whole, or an id occurs twice.
Snapshot to_snapshot(ParticleColumns&& columns);

}  // namespace packstone::formats
