// Writing packings as text.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/snapshot.hpp"

namespace packstone::formats {

/// A text file that is whole or absent; appended to, it grows by whole frames. {} writes the fewest digits that bring a
/// number back to the last bit.
class TextOutput {
 public:
  /// Throws RunError when the file cannot be written.
  explicit TextOutput(const std::filesystem::path& path, bool append = false);

  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    print_values(format, fmt::make_format_args(values...));
  }
  /// Bytes as they are.
  void raw(const void* bytes, std::size_t count);

  /// Puts the file in place. Throws RunError when the disk refuses.
  void finish();

 private:
  static constexpr std::size_t flush_bytes = 1 << 20;

  void print_values(fmt::string_view format, fmt::format_args values);
  void flush();

  std::filesystem::path path_;
  bool append_;
  std::ofstream file_;
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
