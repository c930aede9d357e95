// What the readers of starting files hand over, before it is checked against the scene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/formats/particle_columns.hpp"
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

/// The particles of a CSV table or a LAMMPS data file; a LAMMPS type t is group t-1, ids decide the order. Velocities
/// that are left out are 0. Throws InputError "SOURCE:LINE: column: what; what would be right" where a type has no
/// group in the scene or a density is not that of the group's material.
std::vector<FileParticle> table_particles(const formats::ParticleColumns& table, const Scene& scene);

/// A packstone snapshot: radii at its instant, velocities where it has them, type as group; no contacts.
/// Throws InputError that names the file.
std::vector<FileParticle> read_snapshot_particles(const std::string& path);

}  // namespace packstone::engine
