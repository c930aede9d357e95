// Results as text for people, as JSON and as CSV.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/result.hpp"

namespace packstone::analysis {

/// The measures of one instant of a series.
struct TimedResults {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::vector<MeasureResult> results;
  std::vector<std::string> notes{};  ///< what the snapshot's reader had to assume
};

/// The value with its uncertainty: "0.6363 ± 0.0012" (two digits of the uncertainty), "12.346" without one,
/// "n/a" without value. No unit.
std::string value_text(const Quantity& quantity);

/// A table cell: shortest for integers, six digits otherwise, empty for NaN.
std::string cell_text(double value, ColumnFormat format);

/// "lower [m]", or the name alone for a pure number.
std::string column_title(const Column& column);

/// Aligned lines, one a quantity, with unit, uncertainty and notes; tables up to so many rows each (0: none).
std::string to_text(const std::vector<MeasureResult>& results, std::size_t most_rows = 12);

/// {measure: {key: {value, unit, uncertainty, definition[, note]}, table key: {caption, columns, units, rows}}};
/// null where a number does not exist.
nlohmann::ordered_json to_json(const std::vector<MeasureResult>& results);

/// [{"at": {time [s], step}, measure: {...}, ...}, ...]: "time" itself is the name of a measure.
nlohmann::ordered_json to_json(const std::vector<TimedResults>& series);

/// Writes JSON, indented, under another name and renames. Throws RunError when the disk refuses.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json);

/// Writes DIR/measures.csv (measure,key,value,uncertainty,unit,definition,note) and DIR/MEASURE_TABLE.csv for every
/// table; RFC 4180 quoting; numbers read back to the same bits. Creates the folder. Throws RunError when the disk
/// refuses; every file is whole or absent.
void write_csv(const std::filesystem::path& folder, const std::vector<MeasureResult>& results);

/// The same with a leading column time [s].
void write_csv(const std::filesystem::path& folder, const std::vector<TimedResults>& series);

}  // namespace packstone::analysis
