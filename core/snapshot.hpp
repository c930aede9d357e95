// One instant of a packing: particles, contacts, container. The contract between engine, analysis and viz;
// docs/format.md describes the file dataset by dataset.
#pragma once

#include <array>
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
  std::vector<std::uint8_t> sliding;  ///< 1 where friction is at its Coulomb limit; empty: not known

  std::size_t size() const { return first.size(); }
  void append(const Contacts& more);
};

/// A boundary as the snapshot records it, where it stands at that time: enough to draw it and to measure against it.
struct BoundaryRecord {
  std::string name;
  std::string kind;            ///< as in the scene: "plane", "cylinder", ...
  Vec3 point = Vec3::Zero();   ///< of the plane, or of the flat floor the boundary has [m]
  Vec3 normal = Vec3::Zero();  ///< unit vector of that plane or floor to the particles' side; 0 where there is none
  Vec3 axis = Vec3::Zero();    ///< unit vector across which cross_section is measured; 0 where it encloses nothing
  double cross_section = 0;    ///< that the boundary encloses [m2]
  bool one_sided = true;       ///< particles are only where the triangles' normals point to
  std::vector<Vec3> points{};  ///< of its surface [m]; none of a plane, which has no end
  /// Corners, indices into points, in order around the normal.
  std::vector<std::array<std::int32_t, 3>> triangles{};

  bool operator==(const BoundaryRecord&) const = default;
};

/// What a [[particles]] entry of the scene says about its particles.
struct GroupRecord {
  std::string name;
  std::string material;
  double density = 0;  ///< [kg/m3]; 0: not known
};

/// Field of the state in which a run was stopped: 1 of the particles behind it, 2 of those in contact with them, else
/// 0.
inline constexpr const char* offender_field = "offender";

/// Notes on what another program's file does not say (Snapshot::notes).
inline constexpr const char* note_no_box =
    "the file has no box: the domain is the box around its spheres, not periodic";
inline constexpr const char* note_no_walls =
    "where the walls stand is not in the file, only where particles touch them";
inline constexpr const char* note_no_density = "the file has no densities and no masses";
inline constexpr const char* note_no_periodicity =
    "a LAMMPS data file does not say which sides are periodic: none is taken to be";

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

  /// What the reader of another program's file had to assume, or of the state in which a run was stopped why, a
  /// sentence each.
  std::vector<std::string> notes{};

  std::size_t size() const { return position.size(); }

  /// Mass of the particle in a row from its radius at this instant and its group's density [kg]. While radii grow the
  /// engine moves the mass of the full size instead.
  double mass(std::size_t row) const;

  /// Whether the density of every particle is known.
  bool has_masses() const;

  /// Row of every id that occurs.
  std::map<std::int64_t, std::size_t> rows_by_id() const;
};

/// An axis-aligned region to read [m].
struct Region {
  Vec3 min;
  Vec3 max;
};

/// What to read of a file: by default everything. Of other programs' files all columns are read.
struct ReadOptions {
  std::optional<Region> region;  ///< only chunks whose spheres can touch it, then only such spheres
  bool contacts = true;
  bool fields = true;  ///< Snapshot::fields
  bool rows = true;    ///< else no particles
};

/// The rows along a Morton curve through the box around the centres (G. M. Morton, IBM Ltd., Ottawa, 1966), ties by id:
/// neighbours in space are near in memory, which halves the time of most measures.
std::vector<std::size_t> space_filling_order(const Snapshot& snapshot);

/// The rows by ascending id.
std::vector<std::size_t> id_order(const Snapshot& snapshot);

/// The snapshot with these rows of it, in that order; contacts and all else stay as they are.
Snapshot with_rows(const Snapshot& snapshot, const std::vector<std::size_t>& rows);

/// The rows whose sphere touches the region, contacts and all else as they are.
Snapshot restricted(const Snapshot& snapshot, const Region& region);

/// Writes under a temporary name and renames: the file is whole or absent.
/// Rows are written along a space-filling curve, in chunks with bounding boxes.
/// Throws RunError when the disk refuses.
void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot);

/// Throws InputError that names the file and what is wrong with it.
Snapshot read_snapshot(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace packstone
