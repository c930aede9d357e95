// What the readers of starting files hand over, before it is checked against the scene.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene.hpp"
#include "core/vec3.hpp"

namespace packstone::engine {

/// One particle of a file.
struct FileParticle {
  std::int64_t id = 0;                   ///< decides the order
  std::int64_t line = 0;                 ///< where it stands, counted from 1; 0 in a file without lines
  Vec3 position = Vec3::Zero();          ///< [m]
  Vec3 velocity = Vec3::Zero();          ///< [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
  double radius = 0;                     ///< [m]
  std::int64_t group = 0;                ///< [[particles]] entry
};

/// A table with a header line out of x, y, z, radius, group, vx, vy, vz, wx, wy, wz in any order; ids are the rows.
/// Throws InputError "SOURCE:LINE: column: what; what would be right".
std::vector<FileParticle> read_csv_particles(std::string_view text, const std::string& source_name);

/// A LAMMPS data file of atom_style sphere in units si, atom type t as group t-1. Its box, image flags and coefficients
/// are not used. Throws InputError as above; also where a density is not that of the group's material.
std::vector<FileParticle> read_lammps_particles(std::string_view text, const std::string& source_name,
                                                const Scene& scene);

/// A packstone snapshot: radii at its instant, velocities where it has them, type as group; no contacts.
/// Throws InputError that names the file.
std::vector<FileParticle> read_snapshot_particles(const std::string& path);

}  // namespace packstone::engine
