// What measures know of every particle, as fields to colour and to sort by.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/options.hpp"
#include "core/snapshot.hpp"

namespace packstone::analysis {

/// One value of every particle.
struct ParticleField {
  std::string name = {};            ///< in files, unique among all measures, never changes
  std::string unit = {};            ///< SI; empty for a pure number
  std::string definition = {};      ///< formula, source
  int components = 1;               ///< 1 scalar, 3 vector
  std::vector<double> values = {};  ///< (N * components) by row; no_value where a particle has none
  std::string missing = {};         ///< why there are no values; empty where there are
};

/// The fields, all without values for this reason.
std::vector<ParticleField> without_values(std::vector<ParticleField> fields, const std::string& reason);

/// The values of each particle as numbers.
template <class Number>
std::vector<double> as_values(const std::vector<Number>& numbers) {
  return {numbers.begin(), numbers.end()};
}

/// The fields of the selected measures, in their order, as analyze() selects; names, units and definitions are the same
/// for every snapshot. Throws InputError as analyze() does, and where none of the measures has any.
std::vector<ParticleField> particle_fields(const Snapshot& snapshot, const std::vector<std::string>& selection = {},
                                           const Options& options = {});

/// The formats of write_particles, for messages and help.
inline constexpr const char* particle_formats = ".vtkhdf (snapshot), .vtu, .vtp or .csv";

/// Throws InputError where the name's extension is none of particle_formats.
void require_particle_format(const std::filesystem::path& path);

/// Writes the snapshot with the fields that have values beside its own, in their place where names agree. CSV: a row a
/// particle; id, type, x, y, z, radius, then the fields, with units in the header ("x [m]", vectors as name_x, name_y,
/// name_z), empty where there is no value. Throws InputError for another extension and RunError when the disk refuses.
void write_particles(const std::filesystem::path& path, Snapshot snapshot, const std::vector<ParticleField>& fields);

}  // namespace packstone::analysis
