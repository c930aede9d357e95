// Checksums that packstone writes behind the end of its HDF5 files, where HDF5 does not look: they tell a damaged file
// before HDF5 reads it, which may crash there. docs/format.md has the layout.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace packstone {

/// Bytes of a file that hold the numbers of one dataset.
struct ColumnSum {
  std::uint64_t first = 0;
  std::uint64_t bytes = 0;
  std::uint64_t sum = 0;  ///< of the bytes (checksum_of)
};

/// CRC-64 of ECMA-182, reflected. before: that of the bytes that these go on from.
std::uint64_t checksum_of(const void* bytes, std::size_t count, std::uint64_t before = 0);

/// What stands behind a file's end: the sums of its columns, and of all other bytes, its structure, together.
class Checksums {
 public:
  /// columns: ascending, apart, inside the file; their sums are made here.
  Checksums(std::string_view file, std::vector<ColumnSum> columns);
  /// Those that a file ends with; nothing where it has none, or damaged ones.
  static std::optional<Checksums> behind(std::string_view file);

  /// To be written behind the file.
  std::string text() const;
  /// Whether the structure of the file that they stand behind is as it was written.
  bool fit_structure_of(std::string_view file) const;
  /// Of the column that begins there; nothing where there is no such column.
  std::optional<ColumnSum> column_at(std::uint64_t first) const;

 private:
  Checksums() = default;

  std::vector<ColumnSum> columns_;
  std::uint64_t structure_ = 0;
};

}  // namespace packstone
