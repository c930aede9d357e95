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

/// What the comments at the top say.
struct Head {
  std::string_view format;                ///< behind #format; empty without one
  std::vector<std::string_view> columns;  ///< words of the last comment
};

Head head_of(std::string_view text) {
  Head head;
  while (text.starts_with('#')) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.starts_with(format_key)) {
      const auto parts = words(line.substr(format_key.size()));
      if (head.format.empty() && !parts.empty()) head.format = parts.front();
    } else {
      head.columns = words(line.substr(1));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return head;
}

/// Names of a row's columns in their order, as the format says them.
std::vector<std::string> format_names(std::string_view format) {
  std::vector<std::string> names;
  for (const std::string_view name : split(format, '_')) {
    if (name != attributes) names.emplace_back(name);
  }
  return names;
}

}  // namespace

bool is_yade_text(std::string_view text) {
  if (!head_of(text).format.empty()) return true;
  TextLines lines(text, "");
  if (!lines.next()) return false;
  const auto parts = words(lines.line());
  return parts.size() >= 4 &&
         std::all_of(parts.begin(), parts.end(), [](std::string_view part) { return parsed_number(part).has_value(); });
}

ParticleColumns read_yade_text(std::string_view text, const std::string& source) {
  const Head head = head_of(text);
  const std::string_view format = head.format.empty() ? usual_format : head.format;
  std::vector<std::string> names = format_names(format);
  const bool has_attributes = format.ends_with(attributes);
  const bool more = head.format.empty() || has_attributes;
  TextLines lines(text, source);
  std::vector<std::vector<double>> values;
  ParticleColumns columns;
  columns.source = source;
  while (lines.next()) {
    const auto fields = words(lines.line());
    if (columns.line.empty()) {
      if (has_attributes && head.columns.size() == fields.size()) {
        for (std::size_t k = names.size(); k < fields.size(); ++k) names.emplace_back(head.columns[k]);
      }
      values.resize(names.size());
    }
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
  values.resize(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) add_column(columns, names[k], std::move(values[k]));
  return columns;
}

}  // namespace packstone::formats
