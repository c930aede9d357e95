#include "core/formats/yade_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/formats/number_rows.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

constexpr std::string_view format_key = "#format";
constexpr std::string_view usual_format = "x_y_z_r";
constexpr std::string_view attributes = "attrs";

/// What stands behind #format in the comments at the top; empty without one.
std::string_view declared_format(std::string_view text) {
  while (text.starts_with('#')) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.starts_with(format_key)) {
      const auto parts = words(line.substr(format_key.size()));
      return parts.empty() ? std::string_view() : parts.front();
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

}  // namespace

bool is_yade_text(std::string_view text) {
  if (!declared_format(text).empty()) return true;
  TextLines lines(text, "");
  if (!lines.next()) return false;
  const auto parts = words(lines.line());
  return parts.size() >= 4 &&
         std::all_of(parts.begin(), parts.end(), [](std::string_view part) { return parsed_number(part).has_value(); });
}

ParticleColumns read_yade_text(std::string_view text, const std::string& source) {
  const std::string_view declared = declared_format(text);
  const std::string_view format = declared.empty() ? usual_format : declared;
  std::vector<std::string> names;
  bool more = declared.empty();
  for (const std::string_view name : split(format, '_')) {
    if (name == attributes) {
      more = true;
    } else {
      names.emplace_back(name);
    }
  }
  TextLines lines(text, source);
  std::vector<std::vector<double>> values(names.size());
  ParticleColumns columns;
  columns.source = source;
  while (lines.next()) {
    const auto fields = words(lines.line());
    if (fields.size() < names.size() || (fields.size() > names.size() && !more)) {
      lines.fail(fmt::format("the row has {} fields, the format {} has {}; they must agree", fields.size(), format,
                             names.size()));
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto value = parsed_number(fields[k]);
      if (!value || !std::isfinite(*value)) lines.fail(number_complaint(names[k], fields[k]));
      values[k].push_back(*value);
    }
    columns.line.push_back(lines.number());
  }
  columns.count = columns.line.size();
  for (std::size_t k = 0; k < names.size(); ++k) add_column(columns, names[k], std::move(values[k]));
  return columns;
}

}  // namespace packstone::formats
