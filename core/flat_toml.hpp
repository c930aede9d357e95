// TOML files of keys with one value each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace packstone {

struct TomlEntry {
  std::string key;
  std::string text;           ///< of the value; arrays with commas between
  std::optional<bool> truth;  ///< where the value is true or false
  std::string place;          ///< FILE:LINE:COLUMN of the key
};

/// In the order of the file. Throws InputError where it cannot be read, is no TOML or has tables.
std::vector<TomlEntry> read_flat_toml(const std::filesystem::path& path);

/// A text as a TOML string.
std::string toml_quoted(const std::string& text);

}  // namespace packstone
