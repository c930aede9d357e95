// Writing packings as text.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/files.hpp"
#include "core/snapshot.hpp"

namespace packstone::formats {

/// A text file that is whole or absent. {} writes the fewest digits that bring a number back to the last bit. All
/// functions throw RunError when the disk refuses.
class TextOutput {
 public:
  explicit TextOutput(const std::filesystem::path& path) : file_(path) {}

  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    print_values(format, fmt::make_format_args(values...));
  }
  /// Bytes as they are.
  void raw(const void* bytes, std::size_t count);

  /// Puts the file in place.
  void finish();

 private:
  static constexpr std::size_t flush_bytes = 1 << 20;

  void print_values(fmt::string_view format, fmt::format_args values);
  void flush();

  PendingFile file_;
  fmt::memory_buffer buffer_;
};

/// A column to write beside the columns every format has.
struct OutputColumn {
  std::string name;
  const double* first = nullptr;  ///< of row 0
  std::size_t stride = 1;         ///< from row to row

  double value(std::size_t row) const { return first[row * stride]; }
};

/// Velocity, angular velocity and force where the snapshot has them, a component each; forces are fx, fy, fz.
std::vector<OutputColumn> vector_columns(const Snapshot& snapshot, const std::array<const char*, 3>& velocity,
                                         const std::array<const char*, 3>& angular_velocity);

/// Mass of a particle: its own where the snapshot has masses, else from its group's density [kg].
double mass_of(const Snapshot& snapshot, std::size_t row);

}  // namespace packstone::formats
