// The bed in tests/data/yade as Yade's own deck printed it, to hold beside what Yade exported.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/files.hpp"
#include "core/snapshot.hpp"
#include "core/text_lines.hpp"

namespace packstone::testing {

inline const std::filesystem::path yade_folder = PACKSTONE_SOURCE_DIR "/tests/data/yade";

/// A row of a table by the names of its columns.
using NamedRow = std::map<std::string, double>;

inline Vec3 vector_in(const NamedRow& row, const std::string& x, const std::string& y, const std::string& z) {
  return {row.at(x), row.at(y), row.at(z)};
}

/// Read without the readers under test.
inline std::vector<NamedRow> printed_table(const std::filesystem::path& path) {
  const std::string text = read_text_file(path);
  TextLines lines(text, path.string());
  lines.next();
  const auto names = split(lines.line(), ',');
  std::vector<NamedRow> rows;
  while (lines.next()) {
    const auto fields = split(lines.line(), ',');
    NamedRow& row = rows.emplace_back();
    for (std::size_t k = 0; k < names.size(); ++k) row[std::string(names[k])] = parsed_number(fields.at(k)).value();
  }
  return rows;
}

/// The spheres by id.
inline std::map<std::int64_t, NamedRow> yade_particles() {
  std::map<std::int64_t, NamedRow> particles;
  for (const NamedRow& row : printed_table(yade_folder / "particles.csv")) {
    particles[static_cast<std::int64_t>(row.at("id"))] = row;
  }
  return particles;
}

/// Contacts between spheres by their ids, the first the lower; the force is that on the first.
inline std::map<std::pair<std::int64_t, std::int64_t>, NamedRow> yade_contacts() {
  const auto particles = yade_particles();
  std::map<std::pair<std::int64_t, std::int64_t>, NamedRow> contacts;
  for (const NamedRow& row : printed_table(yade_folder / "contacts.csv")) {
    const auto first = static_cast<std::int64_t>(row.at("id1")), second = static_cast<std::int64_t>(row.at("id2"));
    if (particles.count(first) > 0 && particles.count(second) > 0) contacts[{first, second}] = row;
  }
  return contacts;
}

/// Whether a number printed with so many digits means the other one.
inline bool printed_as(double read, double exact, int digits) {
  if (read == exact) return true;
  const double last_digit = std::pow(10, std::floor(std::log10(std::abs(exact))) - digits + 1);
  constexpr double rounding = 1e-9;  // of the comparison itself
  return std::abs(read - exact) <= (0.5 + rounding) * last_digit;
}

inline bool printed_as(const Vec3& read, const Vec3& exact, int digits) {
  return printed_as(read.x(), exact.x(), digits) && printed_as(read.y(), exact.y(), digits) &&
         printed_as(read.z(), exact.z(), digits);
}

}  // namespace packstone::testing
