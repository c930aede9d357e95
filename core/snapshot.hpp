// One instant of a packing: particles, contacts, container. The contract between engine, analysis and viz;
// docs/format.md describes the file dataset by dataset.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/domain.hpp"
#include "core/vec3.hpp"

namespace packstone {

/// A further quantity a particle carries, stored row by row.
struct Field {
  int components = 1;          ///< 1 scalar, 3 vector
  std::string unit;            ///< SI, e.g. "m/s"; empty for a pure number
  std::vector<double> values;  ///< (N * components)
};

/// Contacts between particles, and of particles with boundaries. All vectors have M rows.
struct Contacts {
  std::vector<std::int64_t> first;    ///< particle id
  std::vector<std::int64_t> second;   ///< particle id, or -1-k for boundary k
  std::vector<Vec3> force;            ///< on the first [N]
  std::vector<Vec3> normal;           ///< unit vector from second to first
  std::vector<double> overlap;        ///< [m]
  std::vector<Vec3> point;            ///< contact point [m]
  std::vector<std::uint8_t> sliding;  ///< 1 where friction is at its Coulomb limit

  std::size_t size() const { return first.size(); }
  void append(const Contacts& more);
};

/// A plane wall as the snapshot records it: enough to draw it and to measure against it.
struct BoundaryRecord {
  std::string name;
  std::string kind;             ///< "plane"
  Vec3 point = Vec3::Zero();    ///< a point of the plane [m]
  Vec3 normal = Vec3::UnitZ();  ///< unit vector to the side of the particles
};

/// What a [[particles]] entry of the scene says about its particles.
struct GroupRecord {
  std::string name;
  std::string material;
  double density = 0;  ///< [kg/m3]
};

/// Everything one snapshot file holds. Rows of all particle arrays agree.
struct Snapshot {
  double time = 0;  ///< [s]
  std::int64_t step = 0;

  std::vector<Vec3> position;           ///< (N) [m], inside the box along periodic axes
  std::vector<double> radius;           ///< (N) [m]
  std::vector<std::int64_t> id;         ///< (N) unique, not the row number
  std::vector<std::int32_t> type;       ///< (N) index into groups
  std::vector<std::int32_t> material;   ///< (N) index into material_names
  std::map<std::string, Field> fields;  ///< further point data by name: "velocity", "force", ...

  std::optional<Contacts> contacts;  ///< absent where the run did not write them
  std::vector<BoundaryRecord> boundaries;
  std::vector<GroupRecord> groups;
  std::vector<std::string> material_names;
  Domain domain;
  Vec3 gravity = Vec3::Zero();  ///< acceleration of the scene, also before it starts [m/s2]

  std::string scene_text;  ///< the scene as run
  std::string scene_hash;  ///< 16 hex digits
  std::string program;     ///< "packstone 0.1.0 (git abc1234)"

  std::size_t size() const { return position.size(); }

  /// Mass of the particle in a row from its radius at this instant and its group's density [kg]. While radii grow the
  /// engine moves the mass of the full size instead.
  double mass(std::size_t row) const;

  /// Row of every id that occurs.
  std::map<std::int64_t, std::size_t> rows_by_id() const;
};

/// An axis-aligned region to read [m].
struct Region {
  Vec3 min;
  Vec3 max;
};

/// What to read of a file: by default everything.
struct ReadOptions {
  std::optional<Region> region;  ///< only chunks whose spheres can touch it, then only such spheres
  bool contacts = true;
};

/// Writes under a temporary name and renames: the file is whole or absent.
/// Rows are written along a space-filling curve, in chunks with bounding boxes.
/// Throws RunError when the disk refuses.
void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot);

/// Throws InputError that names the file and what is wrong with it.
Snapshot read_snapshot(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace packstone
