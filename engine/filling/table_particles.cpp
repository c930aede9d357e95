// Particles of a table of any program as a start.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "engine/filling/particle_readers.hpp"

namespace packstone::engine {

namespace {

constexpr double density_tolerance = 1e-6;            ///< relative: what programs lose when they print a density
constexpr double largest_whole = 9007199254740992.0;  ///< 2^53: beyond it doubles skip whole numbers

class Table {
 public:
  Table(const formats::ParticleColumns& columns, const Scene& scene) : columns_(columns), scene_(scene) {}

  FileParticle particle(std::size_t row) const {
    FileParticle p;
    p.id = columns_.has("id") ? whole("id", row) : static_cast<std::int64_t>(row);
    p.line = columns_.line[row];
    p.position = vector({"x", "y", "z"}, row);
    p.velocity = vector({"vx", "vy", "vz"}, row);
    p.angular_velocity = vector({"wx", "wy", "wz"}, row);
    p.radius = number("radius", row);
    p.group = columns_.has("type") ? whole("type", row) - columns_.first_type : 0;
    if (columns_.first_type != 0) check_type(row, p.group);
    if (columns_.has("density")) check_density(row, p.group);
    return p;
  }

 private:
  /// 0 where the table does not have the column.
  double number(const char* column, std::size_t row) const {
    const auto found = columns_.values.find(column);
    return found == columns_.values.end() ? 0 : found->second[row];
  }

  std::int64_t whole(const char* column, std::size_t row) const {
    const double value = number(column, row);
    if (!(std::abs(value) <= largest_whole)) columns_.fail(row, fmt::format("{}: {:g} is too large", column, value));
    return static_cast<std::int64_t>(value);
  }

  Vec3 vector(const std::array<const char*, 3>& names, std::size_t row) const {
    return {number(names[0], row), number(names[1], row), number(names[2], row)};
  }

  void check_type(std::size_t row, std::int64_t group) const {
    const auto groups = static_cast<std::int64_t>(scene_.particles.size());
    if (group >= 0 && group < groups) return;
    columns_.fail(row,
                  fmt::format("type: {} has no [[particles]] entry in the scene, whose {} stand for the types from "
                              "{}; add one for each type",
                              group + columns_.first_type, groups, columns_.first_type));
  }

  void check_density(std::size_t row, std::int64_t group) const {
    if (group < 0 || group >= static_cast<std::int64_t>(scene_.particles.size())) return;  // refused with its group
    const double density = number("density", row);
    const GroupSpec& spec = scene_.particles[group];
    const MaterialSpec& material = scene_.materials[scene_.material_index(spec.material)];
    if (std::abs(density - material.density) <= density_tolerance * material.density) return;
    columns_.fail(row,
                  fmt::format("density: {:.9g} kg/m3 differs from the {:.9g} kg/m3 of the scene's material \"{}\" for "
                              "particles[{}]; make them equal",
                              density, material.density, material.name, group));
  }

  const formats::ParticleColumns& columns_;
  const Scene& scene_;
};

}  // namespace

std::vector<FileParticle> table_particles(const formats::ParticleColumns& columns, const Scene& scene) {
  const Table table(columns, scene);
  std::vector<FileParticle> particles;
  particles.reserve(columns.count);
  for (std::size_t row = 0; row < columns.count; ++row) particles.push_back(table.particle(row));
  return particles;
}

}  // namespace packstone::engine
