#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/writers.hpp"

namespace packstone::analysis {

namespace {

constexpr int most_decimals = 15;

/// Columns the text takes on a terminal: UTF-8 continuation bytes take none.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t columns, bool to_right = false) {
  const std::string gap(columns - std::min(columns, width(text)), ' ');
  return to_right ? gap + text : text + gap;
}

/// How many quantities after this one lack a value for the same reason as it does.
std::size_t missing_likewise(const std::vector<Quantity>& quantities, std::size_t first) {
  const Quantity& q = quantities[first];
  std::size_t end = first + 1;
  while (end < quantities.size() && !q.value && !quantities[end].value && quantities[end].note == q.note) ++end;
  return end - first - 1;
}

void add_quantities(std::string& text, const MeasureResult& result) {
  std::size_t label_width = 0, value_width = 0;
  for (const auto& q : result.quantities) {
    label_width = std::max(label_width, width(q.label));
    if (q.value) value_width = std::max(value_width, width(value_text(q)));
  }
  for (std::size_t k = 0; k < result.quantities.size(); ++k) {
    const Quantity& q = result.quantities[k];
    std::string line = "  " + padded(q.label, label_width) + "  " + padded(value_text(q), value_width);
    if (q.value && !q.unit.empty()) line += " " + q.unit;
    if (!q.note.empty()) line += "  (" + q.note + ")";
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    const std::size_t more = missing_likewise(result.quantities, k);
    if (more > 1) text += fmt::format("  ... {} more numbers do not exist for this reason\n", more);
    if (more > 1) k += more;
  }
}

void add_table(std::string& text, const Table& table, std::size_t most_rows) {
  const std::size_t shown = std::min(most_rows, table.rows.size());
  std::vector<std::vector<std::string>> lines(shown + 1);
  for (const auto& column : table.columns) lines[0].push_back(column_title(column));
  for (std::size_t r = 0; r < shown; ++r) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      lines[r + 1].push_back(cell_text(table.rows[r][c], table.columns[c].format));
    }
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], width(line[c]));
  }
  text += "\n  " + table.caption + "\n";
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) text += "  " + padded(line[c], widths[c], true);
    text += "\n";
  }
  if (shown < table.rows.size()) {
    text += fmt::format("  ... {} more rows; JSON and CSV hold all\n", table.rows.size() - shown);
  }
}

}  // namespace

std::string value_text(const Quantity& quantity) {
  if (!quantity.value) return "n/a";
  const double value = *quantity.value;
  if (!quantity.uncertainty || !(*quantity.uncertainty > 0)) return fmt::format("{:.5g}", value);
  const double magnitude = std::floor(std::log10(*quantity.uncertainty));
  const double decimals = 1 - magnitude;  // the uncertainty keeps two digits
  if (decimals > most_decimals || decimals < 0) {
    return fmt::format("{:.5g} ± {:.2g}", value, *quantity.uncertainty);
  }
  const int d = static_cast<int>(decimals);
  return fmt::format("{:.{}f} ± {:.{}f}", value, d, *quantity.uncertainty, d);
}

std::string cell_text(double value, ColumnFormat format) {
  if (std::isnan(value)) return "";
  return format == ColumnFormat::integer ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

std::string column_title(const Column& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

std::string to_text(const std::vector<MeasureResult>& results, std::size_t most_rows) {
  std::string text;
  for (const auto& result : results) {
    if (!text.empty()) text += "\n";
    text += result.name + "\n";
    add_quantities(text, result);
    for (const auto& table : result.tables) {
      if (most_rows > 0 && !table.rows.empty()) add_table(text, table, most_rows);
    }
  }
  return text;
}

}  // namespace packstone::analysis
