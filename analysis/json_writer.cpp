#include <cmath>

#include <nlohmann/json.hpp>

#include "analysis/writers.hpp"
#include "core/files.hpp"

namespace packstone::analysis {

namespace {

using nlohmann::ordered_json;

constexpr int indentation = 2;

ordered_json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json number(double value, ColumnFormat format) {
  if (format == ColumnFormat::integer && std::isfinite(value)) return static_cast<std::int64_t>(value);
  return number(std::optional(value));
}

ordered_json to_json(const Quantity& q) {
  ordered_json json{{"value", number(q.value)},
                    {"unit", q.unit},
                    {"uncertainty", number(q.uncertainty)},
                    {"definition", q.definition}};
  if (!q.note.empty()) json["note"] = q.note;
  return json;
}

ordered_json to_json(const Table& table) {
  ordered_json names = ordered_json::array(), units = ordered_json::array(), rows = ordered_json::array();
  for (const auto& column : table.columns) {
    names.push_back(column.name);
    units.push_back(column.unit);
  }
  for (const auto& row : table.rows) {
    ordered_json cells = ordered_json::array();
    for (std::size_t c = 0; c < row.size(); ++c) cells.push_back(number(row[c], table.columns[c].format));
    rows.push_back(std::move(cells));
  }
  return {{"caption", table.caption}, {"columns", names}, {"units", units}, {"rows", rows}};
}

}  // namespace

ordered_json to_json(const std::vector<MeasureResult>& results) {
  ordered_json json = ordered_json::object();
  for (const auto& result : results) {
    ordered_json& measure = json[result.name] = ordered_json::object();
    for (const auto& q : result.quantities) measure[q.key] = to_json(q);
    for (const auto& table : result.tables) measure[table.key] = to_json(table);
  }
  return json;
}

ordered_json to_json(const std::vector<TimedResults>& series) {
  ordered_json json = ordered_json::array();
  for (const auto& instant : series) {
    ordered_json entry{{"at", {{"time", instant.time}, {"step", instant.step}}}};
    entry.update(to_json(instant.results));
    json.push_back(std::move(entry));
  }
  return json;
}

void write_json(const std::filesystem::path& path, const ordered_json& json) {
  write_text_file(path, json.dump(indentation, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace packstone::analysis
