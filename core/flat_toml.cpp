#include "core/flat_toml.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "core/error.hpp"
#include "core/files.hpp"

namespace packstone {

namespace {

std::string place_of(const std::filesystem::path& path, const toml::source_position& at) {
  return fmt::format("{}:{}:{}", path.string(), at.line, at.column);
}

/// Of a string, a number, or an array of these; nothing else has one.
std::optional<std::string> text_of(const toml::node& value) {
  if (const auto* text = value.as_string()) return text->get();
  if (const auto* integer = value.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = value.as_floating_point()) return fmt::format("{}", number->get());
  const auto* array = value.as_array();
  if (!array) return std::nullopt;
  std::string all;
  for (const toml::node& item : *array) {
    const auto text = item.is_array() ? std::nullopt : text_of(item);
    if (!text) return std::nullopt;
    all += (all.empty() ? "" : ",") + *text;
  }
  return all;
}

}  // namespace

std::vector<TomlEntry> read_flat_toml(const std::filesystem::path& path) {
  toml::table table;
  try {
    table = toml::parse(read_text_file(path));
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: not valid TOML: {}", place_of(path, error.source().begin), error.description()));
  }
  std::vector<std::pair<toml::source_position, TomlEntry>> entries;
  for (const auto& [key, value] : table) {
    const toml::source_position at = key.source().begin;
    TomlEntry entry{std::string(key.str()), "", value.value_exact<bool>(), place_of(path, at)};
    const auto text = text_of(value);
    if (!text && !entry.truth) {
      throw InputError(
          fmt::format("{}: {}: expected a text, a number, true, false, or a list of these", entry.place, entry.key));
    }
    entry.text = text.value_or("");
    entries.emplace_back(at, std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.line, a.first.column) < std::pair(b.first.line, b.first.column);
  });
  std::vector<TomlEntry> ordered;
  for (auto& [at, entry] : entries) ordered.push_back(std::move(entry));
  return ordered;
}

std::string toml_quoted(const std::string& text) {
  std::ostringstream quoted;
  quoted << toml::value<std::string>(text);
  return quoted.str();
}

}  // namespace packstone
