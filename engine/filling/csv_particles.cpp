// The table of particles, as spreadsheets and scripts write it.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/text_lines.hpp"
#include "engine/filling/particle_readers.hpp"

namespace packstone::engine {

namespace {

enum Column { x, y, z, radius, group, vx, vy, vz, wx, wy, wz, column_count };

const std::vector<std::string> column_names = {"x", "y", "z", "radius", "group", "vx", "vy", "vz", "wx", "wy", "wz"};
constexpr std::array required_columns = {x, y, z, radius};

/// Which column each field of a row belongs to.
std::vector<Column> read_header(const TextLines& lines) {
  std::vector<Column> header;
  for (const std::string_view field : split(lines.line(), ',')) {
    const std::string name(field);
    if (parsed_number(name)) {
      lines.fail(fmt::format("\"{}\" is no column's name; the first line names the columns, out of {}", name,
                             joined(column_names)));
    }
    const auto found = std::find(column_names.begin(), column_names.end(), name);
    if (found == column_names.end()) {
      const auto near = nearest_name(name, column_names);
      lines.fail(fmt::format("\"{}\" is an unknown column; {}there are: {}", name,
                             near ? fmt::format("did you mean \"{}\"? ", *near) : "", joined(column_names)));
    }
    const auto column = static_cast<Column>(found - column_names.begin());
    if (std::count(header.begin(), header.end(), column)) {
      lines.fail(fmt::format("{}: the header names this column twice; keep one", name));
    }
    header.push_back(column);
  }
  for (const Column needed : required_columns) {
    if (std::count(header.begin(), header.end(), needed)) continue;
    lines.fail(fmt::format("{}: the header lacks this column; x, y, z and radius are needed", column_names[needed]));
  }
  return header;
}

double read_field(const TextLines& lines, Column column, std::string_view field) {
  const auto value = parsed_number(field);
  const bool whole = column == group;
  if (!value || (whole && std::isfinite(*value) && !parsed_integer(field))) {
    lines.fail(fmt::format("{}: \"{}\" is not a {}number; {}", column_names[column], field, whole ? "whole " : "",
                           whole ? "groups are counted from 0, such as 1" : "expected one such as 0.02 or 2e-2"));
  }
  if (!std::isfinite(*value)) lines.fail(fmt::format("{}: \"{}\" is not finite", column_names[column], field));
  return *value;
}

FileParticle read_row(const TextLines& lines, const std::vector<Column>& header) {
  const auto fields = split(lines.line(), ',');
  if (fields.size() != header.size()) {
    lines.fail(fmt::format("the row has {} fields, the header {}; they must agree", fields.size(), header.size()));
  }
  std::array<double, column_count> value{};
  for (std::size_t k = 0; k < header.size(); ++k) value[header[k]] = read_field(lines, header[k], fields[k]);
  return {.line = lines.number(),
          .position = {value[x], value[y], value[z]},
          .velocity = {value[vx], value[vy], value[vz]},
          .angular_velocity = {value[wx], value[wy], value[wz]},
          .radius = value[radius],
          .group = static_cast<std::int64_t>(value[group])};
}

}  // namespace

std::vector<FileParticle> read_csv_particles(std::string_view text, const std::string& source_name) {
  TextLines lines(text, source_name);
  if (!lines.next()) {
    throw InputError(fmt::format("{}: is empty; expected a header line out of {}", source_name, joined(column_names)));
  }
  const std::vector<Column> header = read_header(lines);
  std::vector<FileParticle> particles;
  while (lines.next()) {
    particles.push_back(read_row(lines, header));
    particles.back().id = static_cast<std::int64_t>(particles.size()) - 1;
  }
  return particles;
}

}  // namespace packstone::engine
