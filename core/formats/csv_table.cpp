#include "core/formats/csv_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/number_rows.hpp"
#include "core/formats/text_output.hpp"
#include "core/text.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

const std::vector<std::string> column_names = {"x",  "y",  "z",  "radius", "id", "type", "group", "density", "vx",
                                               "vy", "vz", "wx", "wy",     "wz", "fx",   "fy",    "fz"};
constexpr std::array required_columns = {"x", "y", "z", "radius"};
constexpr std::array whole_columns = {"id", "type", "group"};

template <class Names>
bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void check_name(const TextLines& lines, const std::string& name) {
  if (parsed_number(name)) {
    lines.fail(fmt::format("\"{}\" is no column's name; the first line names the columns, out of {}", name,
                           joined(column_names)));
  }
  if (contains(column_names, name)) return;
  const auto near = nearest_name(name, column_names);
  const bool semicolons = name.find(';') != std::string::npos;
  lines.fail(fmt::format("\"{}\" is an unknown column; {}{}there are: {}", name,
                         semicolons ? "commas stand between columns, points in numbers; " : "",
                         near && !semicolons ? fmt::format("did you mean \"{}\"? ", *near) : "", joined(column_names)));
}

/// The column's name of each field of a row.
std::vector<std::string> read_header(const TextLines& lines) {
  std::vector<std::string> header;
  for (const std::string_view field : split(lines.line(), ',')) {
    const std::string name(field);
    check_name(lines, name);
    if (contains(header, name)) lines.fail(fmt::format("{}: the header names this column twice; keep one", name));
    header.push_back(name);
  }
  for (const char* needed : required_columns) {
    if (contains(header, needed)) continue;
    lines.fail(fmt::format("{}: the header lacks this column; x, y, z and radius are needed", needed));
  }
  if (contains(header, "type") && contains(header, "group")) lines.fail("group: means the same as type; keep one");
  return header;
}

double read_field(const TextLines& lines, const std::string& column, std::string_view field) {
  const auto value = parsed_number(field);
  const bool whole = contains(whole_columns, column);
  if (whole && (!value || (std::isfinite(*value) && !parsed_integer(field)))) {
    lines.fail(
        fmt::format("{}: \"{}\" is not a whole number; {}s are counted from 0, such as 1", column, field, column));
  }
  if (!value || !std::isfinite(*value)) lines.fail(number_complaint(column, field));
  return *value;
}

}  // namespace

bool is_csv_table(std::string_view text) {
  TextLines lines(text, "");
  if (!lines.next()) return false;
  const auto fields = split(lines.line(), ',');
  return fields.size() > 1 && std::find(fields.begin(), fields.end(), "x") != fields.end();
}

ParticleColumns read_csv_table(std::string_view text, const std::string& source) {
  TextLines lines(text, source);
  if (!lines.next()) {
    throw InputError(fmt::format("{}: is empty; expected a header line out of {}", source, joined(column_names)));
  }
  const std::vector<std::string> header = read_header(lines);
  std::vector<std::vector<double>> values(header.size());
  ParticleColumns columns;
  columns.source = source;
  while (lines.next()) {
    const auto fields = split(lines.line(), ',');
    if (fields.size() != header.size()) {
      lines.fail(fmt::format("the row has {} fields, the header {}; they must agree", fields.size(), header.size()));
    }
    for (std::size_t k = 0; k < header.size(); ++k) values[k].push_back(read_field(lines, header[k], fields[k]));
    columns.line.push_back(lines.number());
  }
  columns.count = columns.line.size();
  for (std::size_t k = 0; k < header.size(); ++k) add_column(columns, header[k], std::move(values[k]));
  return columns;
}

void write_csv_table(const std::filesystem::path& path, const Snapshot& s) {
  TextOutput out(path);
  const bool with_density = s.size() > 0 && s.has_masses();
  const auto extra = vector_columns(s, {"vx", "vy", "vz"}, {"wx", "wy", "wz"});
  out.print("id,type,x,y,z,radius{}", with_density ? ",density" : "");
  for (const auto& column : extra) out.print(",{}", column.name);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3& p = s.position[i];
    out.print("\n{},{},{},{},{},{}", s.id[i], s.type[i], p.x(), p.y(), p.z(), s.radius[i]);
    if (with_density) out.print(",{}", s.groups[static_cast<std::size_t>(s.type[i])].density);
    for (const auto& column : extra) out.print(",{}", column.value(i));
  }
  out.print("\n");
  out.finish();
}

}  // namespace packstone::formats
