// What a measure hands over: numbers with their unit, uncertainty and definition, and tables.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace packstone::analysis {

/// One number of a measure. Never NaN: a number that does not exist has no value and a note that says why.
struct Quantity {
  std::string key = {};                    ///< name in JSON and CSV, unique within its measure, never changes
  std::string label = {};                  ///< name for people
  std::optional<double> value = {};        ///< in unit
  std::string unit = {};                   ///< SI; empty for a pure number
  std::optional<double> uncertainty = {};  ///< one standard deviation, in unit; definition says of what
  std::string definition = {};             ///< formula, region, source
  std::string note = {};                   ///< why there is no value, or what to know about this one
};

/// How a column is written.
enum class ColumnFormat { general, integer };

struct Column {
  std::string name;
  std::string unit = {};  ///< SI; empty for a pure number
  ColumnFormat format = ColumnFormat::general;
};

/// Stands in a table's cell that has no value.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Rows of numbers; no_value is null in JSON and empty in CSV.
struct Table {
  std::string key = {};      ///< name in JSON, and in the CSV file's name
  std::string caption = {};  ///< what a row is, and how it is defined
  std::vector<Column> columns = {};
  std::vector<std::vector<double>> rows = {};
};

struct MeasureResult {
  std::string name;  ///< of the measure
  std::vector<Quantity> quantities = {};
  std::vector<Table> tables = {};

  /// Null when there is no such quantity or table.
  const Quantity* quantity(std::string_view key) const;
  const Table* table(std::string_view key) const;
};

/// The measures of one instant of a series.
struct TimedResults {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::vector<MeasureResult> results;
  std::vector<std::string> notes{};  ///< what the snapshot's reader had to assume
};

/// The quantity without value, and the reason.
Quantity not_applicable(Quantity quantity, std::string reason);

}  // namespace packstone::analysis
