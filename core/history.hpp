// history.csv: how the run's totals go over time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace packstone {

/// A table of named columns of equal length.
struct History {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> values;  ///< one vector a column

  std::size_t rows() const { return values.empty() ? 0 : values.front().size(); }
  bool has(const std::string& column) const;
  /// Throws InputError that lists the columns there are.
  const std::vector<double>& column(const std::string& name) const;
};

/// A last row without its line end, as a kill leaves it, is left out.
/// Throws InputError with file and line when a row is not as long as the header or not a number.
History read_history(const std::filesystem::path& path);

}  // namespace packstone
