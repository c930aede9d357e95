#include "core/scene_difference.hpp"

#include <map>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "core/error.hpp"

namespace packstone {

namespace {

using Values = std::map<std::string, std::string>;

void add(const toml::node& node, const std::string& key, Values& values) {
  const toml::array* array = node.as_array();
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, value] : *table) {
      add(value, key.empty() ? std::string(name.str()) : key + "." + std::string(name.str()), values);
    }
  } else if (array && array->is_homogeneous<toml::table>()) {
    for (std::size_t k = 0; k < array->size(); ++k) add(*array->get(k), fmt::format("{}[{}]", key, k), values);
  } else {
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    values[key] = text.str();
  }
}

Values values_of(const std::string& text) {
  Values values;
  try {
    add(toml::parse(text), "", values);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("the scene is not valid TOML: {}", error.description()));
  }
  return values;
}

}  // namespace

std::vector<std::string> differing_keys(const std::string& one, const std::string& other) {
  const Values a = values_of(one), b = values_of(other);
  std::vector<std::string> keys;
  for (const auto& [key, value] : a) {
    const auto there = b.find(key);
    if (there == b.end() || there->second != value) keys.push_back(key);
  }
  for (const auto& [key, value] : b) {
    if (a.count(key) == 0) keys.push_back(key);
  }
  return keys;
}

}  // namespace packstone
