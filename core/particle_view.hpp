// The particles of a packing where they lie, in memory or in a file: who looks at some of them does not hold all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace packstone {

/// Field::values of a snapshot, where they lie.
struct FieldColumn {
  int components = 1;
  std::string unit;
  std::span<const double> values;  ///< (N * components)
};

/// Rows of a chunk, in files and in memory.
inline constexpr std::size_t rows_a_chunk = 4096;

/// Rows [first, last) of particles that stand near each other, and a box that holds all of their spheres.
struct RowChunk {
  std::size_t first;
  std::size_t last;
  Region box;  ///< [m]
};

/// The columns of a snapshot; what they belong to must outlive the view.
struct ParticleView {
  const Snapshot* snapshot;  ///< all but the particles; their rows too where the view is of a snapshot in memory
  std::span<const Vec3> position{};
  std::span<const double> radius{};
  std::span<const std::int32_t> type{};
  std::span<const std::int32_t> material{};
  std::map<std::string, FieldColumn> fields{};
  std::vector<RowChunk> chunks{};  ///< ascending, of all rows; a view of a snapshot in memory has none
  std::string unchecked_file{};    ///< for messages, where check_rows has something to find; else empty

  /// Of a snapshot in memory.
  ParticleView(const Snapshot& whole);

  std::size_t size() const { return position.size(); }
};

/// Of all points of spheres; where there are none, its corners are infinite and the wrong way round.
Region box_of(std::span<const Vec3> centres, std::span<const double> radii);

/// Of spheres that stand in some order, so many in each.
std::vector<RowChunk> chunks_of(std::span<const Vec3> centres, std::span<const double> radii);

/// The chunks of a view; where it has none, of its rows as they stand.
std::vector<RowChunk> chunks_of(const ParticleView& particles);

/// Throws InputError where the rows of a chunk hold what no snapshot may: positions that are not numbers, negative
/// radii, spheres outside of the chunk's box, groups and materials there are not.
void check_rows(const ParticleView& particles, const RowChunk& chunk);

}  // namespace packstone
