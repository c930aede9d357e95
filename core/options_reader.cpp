#include "core/options_reader.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packstone {

namespace {

std::string located(const toml::source_region& source) {
  const std::string name = source.path ? *source.path : "";
  if (name.starts_with("--set")) return name;
  return fmt::format("{}:{}:{}", name, source.begin.line, source.begin.column);
}

/// Where a key stands, rather than its value.
std::string located(const toml::table& table, std::string_view key) {
  const auto found = table.find(key);
  const auto& source = found->first.source();
  return source.path && source.begin ? located(source) : located(found->second.source());
}

toml::table parsed(const std::string& text, const std::string& source_name) {
  try {
    return toml::parse(text, source_name);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: not valid TOML: {}", located(error.source()), error.description()));
  }
}

/// Splits "particles[0].count" into names and numbers.
std::vector<std::string> path_parts(std::string path) {
  std::replace(path.begin(), path.end(), '[', '.');
  std::erase(path, ']');
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    parts.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// Puts "key=value" into the tree; tables on the way are made, array entries must exist.
void apply_override(toml::table& root, const std::string& text) {
  const std::string source = "--set " + text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError(source + ": expected KEY=VALUE, such as dynamics.time_step=\"10 us\"");
  }
  auto parts = path_parts(text.substr(0, equals));
  const std::string key = parts.back();
  parts.pop_back();
  const std::string value = text.substr(equals + 1);
  toml::table holder;
  try {
    holder = toml::parse("value = " + value, source);
  } catch (const toml::parse_error&) {
    holder = toml::table{};  // bare words and quantities need no quotes on the command line
    holder.insert("value", value);
  }
  toml::node* node = &root;
  for (const auto& part : parts) {
    if (auto* array = node->as_array()) {
      const bool is_number = !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
      const std::size_t index = is_number && part.size() < 10 ? std::stoul(part) : array->size();
      if (index >= array->size()) {
        throw InputError(
            fmt::format("{}: there is no entry [{}]; entries go from 0 to {}", source, part, array->size() - 1));
      }
      node = array->get(index);
    } else if (auto* table = node->as_table()) {
      if (!table->contains(part)) table->insert(part, toml::table{});
      node = table->get(part);
    }
  }
  auto* table = node->as_table();
  if (!table) throw InputError(source + ": " + text.substr(0, equals) + " is not a key of a table");
  table->insert_or_assign(key, std::move(*holder.get("value")));
}

}  // namespace

struct OptionReader::Impl {
  struct Level {
    const toml::table* table;  ///< nullptr where the table is absent and defaults hold
    std::string path;
    std::vector<std::string> known;
  };

  toml::table root;
  std::string source_name;
  std::map<std::string, std::string>& locations;
  std::map<std::string, std::string> overridden;
  std::vector<Level> levels;

  std::string path_of(const std::string& key) const {
    return levels.back().path.empty() ? key : levels.back().path + "." + key;
  }

  [[noreturn]] void fail(const std::string& path, const std::string& what) const {
    const auto found = locations.find(path);
    throw InputError(fmt::format("{}: {}: {}", found == locations.end() ? source_name : found->second, path, what));
  }

  /// The node of a key, noted as known and located; nullptr when absent.
  const toml::node* find(const OptionInfo& info) {
    Level& level = levels.back();
    level.known.push_back(info.key);
    const toml::node* node = level.table ? level.table->get(info.key) : nullptr;
    if (node) {
      const std::string path = path_of(info.key);
      const auto set = overridden.find(path);
      locations[path] = set != overridden.end() ? set->second : located(*level.table, info.key);
    }
    return node;
  }

  const toml::node* find(const OptionInfo& info, Presence presence) {
    const toml::node* node = find(info);
    if (!node && presence == Presence::required && levels.back().table) {
      if (const auto misspelt = nearest_name(info.key, strangers())) fail_unknown(*misspelt, std::string(info.key));
      const std::string& table = levels.back().path;
      const auto found = locations.find(table);
      const std::string unit = *info.unit.symbol ? fmt::format(" [{}]", info.unit.symbol) : "";
      throw InputError(fmt::format("{}: {}: is missing; it is required: {}{}",
                                   found == locations.end() ? source_name : found->second, path_of(info.key), info.help,
                                   unit));
    }
    return node;
  }

  /// Keys of the current table that have not been described so far.
  std::vector<std::string> strangers() const {
    const Level& level = levels.back();
    std::vector<std::string> names;
    if (!level.table) return names;
    for (const auto& [key, node] : *level.table) {
      const std::string name(key.str());
      if (std::find(level.known.begin(), level.known.end(), name) == level.known.end()) names.push_back(name);
    }
    return names;
  }

  [[noreturn]] void fail_unknown(const std::string& name, const std::optional<std::string>& meant) const {
    const std::string path = path_of(name);
    const auto set = overridden.find(path);
    throw InputError(fmt::format(
        "{}: {}: unknown key; {}", set != overridden.end() ? set->second : located(*levels.back().table, name), path,
        meant ? fmt::format("did you mean \"{}\"?", *meant) : "known here: " + joined(levels.back().known)));
  }

  double number(const OptionInfo& info, const std::string& path, const toml::node& node) const {
    double value = 0;
    if (const auto text = node.value_exact<std::string>()) {
      try {
        value = parse_quantity(*text, info.unit);
      } catch (const InputError& error) {
        fail(path, error.what());
      }
    } else if (node.is_number()) {
      value = *node.value<double>();
    } else {
      fail(path, "expected a number" + std::string(*info.unit.symbol ? " in " : "") + info.unit.symbol);
    }
    if (!std::isfinite(value)) fail(path, "is not a finite number");
    if (!info.range.contains(value)) {
      fail(path, fmt::format("{:g}{}{} is out of range; it must be {}", value, *info.unit.symbol ? " " : "",
                             info.unit.symbol, info.range.text()));
    }
    return value;
  }

  Vec3 vector(const OptionInfo& info, const toml::node& node) const {
    const std::string path = path_of(info.key);
    const auto* array = node.as_array();
    if (!array || array->size() != 3) fail(path, "expected three numbers, [x, y, z]");
    Vec3 value;
    for (int k = 0; k < 3; ++k) value[k] = number(info, path, *array->get(k));
    return value;
  }

  std::int64_t integer(const OptionInfo& info, const toml::node& node) const {
    const std::string path = path_of(info.key);
    if (!node.is_integer()) fail(path, "expected a whole number");
    const std::int64_t value = *node.value_exact<std::int64_t>();
    if (!info.range.contains(static_cast<double>(value))) {
      fail(path, fmt::format("{} is out of range; it must be {}", value, info.range.text()));
    }
    return value;
  }

  std::string text(const OptionInfo& info, const toml::node& node) const {
    const auto found = node.value_exact<std::string>();
    if (!found || found->empty()) fail(path_of(info.key), "expected a text in quotes, not empty");
    return *found;
  }

  int choice(const std::string& path, const ChoiceNames& names, const toml::node& node) const {
    const auto word = node.value_exact<std::string>();
    if (!word) fail(path, "expected one of: " + joined(names));
    const auto found = std::find(names.begin(), names.end(), *word);
    if (found == names.end()) {
      const auto near = nearest_name(*word, names);
      fail(path,
           fmt::format("\"{}\" is unknown; {}expected one of: {}", *word,
                       near && names.size() > 1 ? fmt::format("did you mean \"{}\"? ", *near) : "", joined(names)));
    }
    return static_cast<int>(found - names.begin());
  }

  void enter(const toml::table* table, std::string path) { levels.push_back({table, std::move(path), {}}); }

  /// Leaves a table after refusing what was not described in it.
  void leave() {
    for (const std::string& name : strangers()) fail_unknown(name, nearest_name(name, levels.back().known));
    levels.pop_back();
  }
};

OptionReader::OptionReader(const std::string& text, const std::string& source_name,
                           const std::vector<std::string>& overrides, std::map<std::string, std::string>& locations)
    : impl_(new Impl{parsed(text, source_name), source_name, locations, {}, {}}) {
  for (const auto& override_text : overrides) {
    apply_override(impl_->root, override_text);
    impl_->overridden[override_text.substr(0, override_text.find('='))] = "--set " + override_text;
  }
  impl_->enter(&impl_->root, "");
}

OptionReader::~OptionReader() = default;

void OptionReader::finish() { impl_->leave(); }

void OptionReader::number(const OptionInfo& info, double& value, Presence presence) {
  if (const auto* node = impl_->find(info, presence)) value = impl_->number(info, impl_->path_of(info.key), *node);
}

void OptionReader::number(const OptionInfo& info, std::optional<double>& value) {
  if (const auto* node = impl_->find(info)) value = impl_->number(info, impl_->path_of(info.key), *node);
}

void OptionReader::integer(const OptionInfo& info, std::int64_t& value, Presence presence) {
  if (const auto* node = impl_->find(info, presence)) value = impl_->integer(info, *node);
}

void OptionReader::integer(const OptionInfo& info, std::optional<std::int64_t>& value) {
  if (const auto* node = impl_->find(info)) value = impl_->integer(info, *node);
}

void OptionReader::boolean(const OptionInfo& info, bool& value) {
  const auto* node = impl_->find(info);
  if (!node) return;
  if (!node->is_boolean()) impl_->fail(impl_->path_of(info.key), "expected true or false");
  value = *node->value_exact<bool>();
}

void OptionReader::text(const OptionInfo& info, std::string& value, Presence presence) {
  if (const auto* node = impl_->find(info, presence)) value = impl_->text(info, *node);
}

void OptionReader::text(const OptionInfo& info, std::optional<std::string>& value) {
  if (const auto* node = impl_->find(info)) value = impl_->text(info, *node);
}

void OptionReader::vector(const OptionInfo& info, Vec3& value, Presence presence) {
  if (const auto* node = impl_->find(info, presence)) value = impl_->vector(info, *node);
}

void OptionReader::vector(const OptionInfo& info, std::optional<Vec3>& value) {
  if (const auto* node = impl_->find(info)) value = impl_->vector(info, *node);
}

void OptionReader::number_or(const OptionInfo& info, const char* word, std::optional<double>& value) {
  const auto* node = impl_->find(info);
  if (!node) return;
  if (node->value_exact<std::string>() == word) {
    value.reset();
  } else {
    value = impl_->number(info, impl_->path_of(info.key), *node);
  }
}

void OptionReader::numbers(const OptionInfo& info, std::vector<double>& value) {
  const auto* node = impl_->find(info);
  if (!node) return;
  const std::string path = impl_->path_of(info.key);
  const auto* array = node->as_array();
  if (!array) impl_->fail(path, "expected a list of numbers");
  value.clear();
  for (const auto& entry : *array) value.push_back(impl_->number(info, path, entry));
}

void OptionReader::texts(const OptionInfo& info, std::vector<std::string>& value) {
  const auto* node = impl_->find(info);
  if (!node) return;
  const auto* array = node->as_array();
  if (!array) impl_->fail(impl_->path_of(info.key), "expected a list of texts in quotes");
  value.clear();
  for (const auto& entry : *array) value.push_back(impl_->text(info, entry));
}

void OptionReader::polygons(const OptionInfo& info, std::vector<std::vector<Vec3>>& value) {
  const auto* node = impl_->find(info);
  if (!node) return;
  const auto fail = [&] {
    impl_->fail(impl_->path_of(info.key),
                "expected a list of polygons, each a list of corners: "
                "[[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]");
  };
  const auto* list = node->as_array();
  if (!list) fail();
  value.clear();
  for (const auto& entry : *list) {
    const auto* corners = entry.as_array();
    if (!corners) fail();
    value.emplace_back();
    for (const auto& corner : *corners) value.back().push_back(impl_->vector(info, corner));
  }
}

void OptionReader::number_or_table(const OptionInfo& info, std::optional<double>& value, bool& is_table,
                                   const std::function<void()>& describe) {
  const auto* node = impl_->find(info);
  if (!node) return;
  const std::string path = impl_->path_of(info.key);
  is_table = node->is_table();
  if (!is_table) {
    value = impl_->number(info, path, *node);
    return;
  }
  impl_->enter(node->as_table(), path);
  describe();
  impl_->leave();
}

void OptionReader::choices(const OptionInfo& info, const ChoiceNames& names, std::vector<int>& value) {
  const auto* node = impl_->find(info);
  if (!node) return;
  const std::string path = impl_->path_of(info.key);
  const auto* array = node->as_array();
  if (!array) impl_->fail(path, "expected a list out of: " + joined(names));
  value.clear();
  for (const auto& entry : *array) {
    const int index = impl_->choice(path, names, entry);
    if (std::find(value.begin(), value.end(), index) == value.end()) value.push_back(index);
  }
}

void OptionReader::choice_index(const OptionInfo& info, const ChoiceNames& names, int& index, Presence presence) {
  if (const auto* node = impl_->find(info, presence)) index = impl_->choice(impl_->path_of(info.key), names, *node);
}

void OptionReader::table(const OptionInfo& info, Presence presence, const std::function<void()>& describe) {
  const auto* node = impl_->find(info, presence);
  const std::string path = impl_->path_of(info.key);
  if (node && !node->is_table()) impl_->fail(path, fmt::format("expected a table, [{}]", path));
  impl_->enter(node ? node->as_table() : nullptr, path);
  describe();
  impl_->leave();
}

void OptionReader::optional_table(const OptionInfo& info, bool& present, const std::function<void()>& describe) {
  present = impl_->levels.back().table && impl_->levels.back().table->contains(info.key);
  table(info, Presence::has_default, describe);
}

std::size_t OptionReader::begin_tables(const OptionInfo& info, std::size_t minimum, std::size_t) {
  const auto* node = impl_->find(info, minimum > 0 ? Presence::required : Presence::has_default);
  const std::string path = impl_->path_of(info.key);
  const auto* array = node ? node->as_array() : nullptr;
  if (node && (!array || !std::all_of(array->begin(), array->end(), [](const auto& n) { return n.is_table(); }))) {
    impl_->fail(path, fmt::format("expected tables, [[{}]]", path));
  }
  const std::size_t count = array ? array->size() : 0;
  if (count < minimum) impl_->fail(path, fmt::format("at least {} is needed", minimum));
  return count;
}

void OptionReader::begin_entry(const OptionInfo& info, std::size_t index) {
  const auto* entry = impl_->levels.back().table->get(info.key)->as_array()->get(index);
  const std::string path = fmt::format("{}[{}]", impl_->path_of(info.key), index);
  impl_->locations[path] = located(entry->source());
  impl_->enter(entry->as_table(), path);
}

void OptionReader::end_entry() { impl_->leave(); }

void OptionReader::end_tables() {}

}  // namespace packstone
