// The scene's reference, as a page and as a list, from the same descriptions that read it.

#include <fmt/format.h>

#include "core/options_writer.hpp"
#include "core/scene.hpp"
#include "core/text.hpp"

namespace packstone {

namespace {

struct DocumentedKey {
  std::string table;  ///< "[dynamics]", "[[material]]", empty at the top
  std::string key;
  std::string type;
  std::string allowed;
  std::string default_value;  ///< empty: none
  bool required = false;
  std::string help;
};

struct DocumentedTable {
  std::string heading;
  std::string help;
  std::vector<DocumentedKey> keys;
};

class OptionDocumenter : public OptionVisitor {
 public:
  std::vector<DocumentedTable> tables_seen = {{"", "", {}}};

  void number(const OptionInfo& info, double& value, Presence presence) override {
    add(info, "number", info.range.text(), fmt::format("{:g}", value), presence);
  }
  void number(const OptionInfo& info, std::optional<double>&) override {
    add(info, "number", info.range.text(), "", Presence::has_default);
  }
  void integer(const OptionInfo& info, std::int64_t& value, Presence presence) override {
    add(info, "whole number", info.range.text(), fmt::format("{}", value), presence);
  }
  void integer(const OptionInfo& info, std::optional<std::int64_t>&) override {
    add(info, "whole number", info.range.text(), "", Presence::has_default);
  }
  void boolean(const OptionInfo& info, bool& value) override {
    add(info, "true or false", "", value ? "true" : "false", Presence::has_default);
  }
  void text(const OptionInfo& info, std::string& value, Presence presence) override {
    add(info, "text", "", value, presence);
  }
  void text(const OptionInfo& info, std::optional<std::string>&) override {
    add(info, "text", "", "", Presence::has_default);
  }
  void vector(const OptionInfo& info, Vec3& value, Presence presence) override {
    add(info, "three numbers", info.range.text(), fmt::format("[{:g}, {:g}, {:g}]", value[0], value[1], value[2]),
        presence);
  }
  void vector(const OptionInfo& info, std::optional<Vec3>&) override {
    add(info, "three numbers", info.range.text(), "", Presence::has_default);
  }
  void number_or(const OptionInfo& info, const char* word, std::optional<double>&) override {
    add(info, fmt::format("number or \"{}\"", word), info.range.text(), word, Presence::has_default);
  }
  void numbers(const OptionInfo& info, std::vector<double>&) override {
    add(info, "list of numbers", info.range.text(), "", Presence::has_default);
  }
  void texts(const OptionInfo& info, std::vector<std::string>&) override {
    add(info, "list of texts", "", "", Presence::has_default);
  }
  void polygons(const OptionInfo& info, std::vector<std::vector<Vec3>>&) override {
    add(info, "list of lists of three numbers", "", "", Presence::has_default);
  }
  void number_or_table(const OptionInfo& info, std::optional<double>&, bool&,
                       const std::function<void()>& describe) override {
    add(info, "number or table", info.range.text(), "", Presence::has_default);
    table(info, Presence::has_default, describe);
  }
  void choices(const OptionInfo& info, const ChoiceNames& names, std::vector<int>&) override {
    add(info, "list", joined(names), "[]", Presence::has_default);
  }
  void table(const OptionInfo& info, Presence, const std::function<void()>& describe) override {
    const std::string outer = path_;
    path_ += (outer.empty() ? "" : ".") + std::string(info.key);
    tables_seen.push_back({fmt::format("[{}]", path_), info.help, {}});
    describe();
    path_ = outer;
  }
  void optional_table(const OptionInfo& info, bool&, const std::function<void()>& describe) override {
    table(info, Presence::has_default, describe);
  }

 protected:
  void choice_index(const OptionInfo& info, const ChoiceNames& names, int& index, Presence presence) override {
    add(info, "word", joined(names), names[index], presence);
  }
  std::size_t begin_tables(const OptionInfo& info, std::size_t minimum, std::size_t) override {
    tables_seen.push_back(
        {fmt::format("[[{}]]", info.key), fmt::format("{}; {} or more", info.help, minimum == 0 ? "none" : "one"), {}});
    return 1;
  }
  void begin_entry(const OptionInfo& info, std::size_t) override { path_ = info.key; }
  void end_entry() override { path_.clear(); }
  void end_tables() override {}

 private:
  std::string path_;

  void add(const OptionInfo& info, const std::string& type, const std::string& allowed, const std::string& value,
           Presence presence) {
    const bool required = presence == Presence::required;
    const std::string unit = *info.unit.symbol ? fmt::format(" [{}]", info.unit.symbol) : "";
    tables_seen.back().keys.push_back(
        {tables_seen.back().heading, info.key, type + unit, allowed, required ? "" : value, required, info.help});
  }
};

std::vector<DocumentedTable> documented_scene() {
  Scene defaults;
  OptionDocumenter documenter;
  describe(documenter, defaults);
  return documenter.tables_seen;
}

}  // namespace

std::string to_toml(const Scene& scene) {
  Scene copy = scene;  // the visitor interface is shared with readers, which write
  OptionWriter writer;
  describe(writer, copy);
  return writer.text();
}

std::string scene_reference_markdown() {
  std::string page =
      "# The scene file\n\n"
      "Generated by `packstone info --scene-reference markdown`; a test keeps it in step with the program.\n\n"
      "A scene is a TOML file. Numbers are SI; any of them may carry a unit in a string instead, \"20 mm\", \"50 us\", "
      "\"7.8 g/cm3\".\nUnknown keys are errors. Any key can be overridden on the command line: "
      "`--set dynamics.time_step=\"10 us\"`, `--set particles[0].count=100`.\n";
  for (const auto& table : documented_scene()) {
    page += table.heading.empty() ? "\n## Top level\n\n" : fmt::format("\n## {}\n\n{}.\n\n", table.heading, table.help);
    if (table.keys.empty()) continue;
    page += "| key | value | allowed | default | meaning |\n|---|---|---|---|---|\n";
    for (const auto& key : table.keys) {
      page += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.key, key.type, key.allowed,
                          key.required ? "required" : (key.default_value.empty() ? "" : "`" + key.default_value + "`"),
                          key.help);
    }
  }
  return page;
}

std::string scene_reference_text() {
  std::string text;
  for (const auto& table : documented_scene()) {
    if (!table.heading.empty()) text += fmt::format("{}  {}\n", table.heading, table.help);
    for (const auto& key : table.keys) {
      const std::string value = key.required ? "required" : (key.default_value.empty() ? "" : "= " + key.default_value);
      text += fmt::format("  {:<22}{:<26}{:<20}{}{}\n", key.key, key.type, value, key.help,
                          key.allowed.empty() ? "" : " (" + key.allowed + ")");
    }
  }
  return text;
}

}  // namespace packstone
