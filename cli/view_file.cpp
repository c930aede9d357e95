#include "cli/view_file.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/flat_toml.hpp"
#include "core/text.hpp"

namespace packstone::cli {

namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

const std::vector<std::pair<std::string, Values>> presets = {
    // 17 cm wide at 300 dots an inch; journals have the title below.
    {"paper", {{"size", "2000x1500"}, {"supersampling", "3"}, {"occlusion", "0.7"}, {"title", "-"}}},
    {"slide", {{"size", "1920x1080"}, {"font-scale", "1.4"}, {"occlusion", "0.7"}}},
    {"dark", {{"size", "1920x1080"}, {"font-scale", "1.4"}, {"occlusion", "0.7"}, {"ground", "dark"}}}};

const ViewOption* find(const std::vector<ViewOption>& options, const std::string& name) {
  const auto found =
      std::find_if(options.begin(), options.end(), [&](const ViewOption& option) { return option.name == name; });
  return found == options.end() ? nullptr : &*found;
}

[[noreturn]] void refuse_key(const TomlEntry& entry, const std::vector<ViewOption>& options) {
  std::vector<std::string> names = {"preset"};
  for (const ViewOption& option : options) {
    if (option.of_view) names.push_back(option.name);
  }
  const ViewOption* known = find(options, entry.key);
  if (known && !known->of_view) {
    throw InputError(fmt::format("{}: {} does not belong to a view; it stands in the call, as --{}", entry.place,
                                 entry.key, entry.key));
  }
  const auto near = nearest_name(entry.key, names);
  throw InputError(fmt::format("{}: unknown key '{}'{}; there are {}", entry.place, entry.key,
                               near ? fmt::format(", did you mean '{}'?", *near) : "", joined(names)));
}

/// What a line of a view file sets; nothing where it turns a flag off.
std::optional<ViewSetting> setting_of(const TomlEntry& entry, const ViewOption& option) {
  if (option.flag != entry.truth.has_value()) {
    throw InputError(fmt::format("{}: {}: expected {}", entry.place, entry.key,
                                 option.flag ? "true or false" : "a text or a number"));
  }
  if (option.flag && !*entry.truth) return std::nullopt;
  return ViewSetting{option.name, entry.text, option.flag, entry.place};
}

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const auto& [name, values] : presets) names.push_back(name);
  return names;
}

std::vector<ViewSetting> view_settings(const std::vector<ViewOption>& options, const std::string& file,
                                       const std::string& preset) {
  std::vector<ViewSetting> settings;
  std::vector<std::string> decided;  // by the call or the file
  for (const ViewOption& option : options) {
    if (option.given) decided.push_back(option.name);
  }
  const auto open = [&](const std::string& name) {
    return std::find(decided.begin(), decided.end(), name) == decided.end();
  };
  std::string chosen = preset, chosen_by = "--preset";
  for (const TomlEntry& entry : file.empty() ? std::vector<TomlEntry>{} : read_flat_toml(file)) {
    if (entry.key == "preset") {
      if (!preset.empty()) continue;
      chosen = entry.text;
      chosen_by = entry.place + ": preset";
      continue;
    }
    const ViewOption* option = find(options, entry.key);
    if (!option || !option->of_view) refuse_key(entry, options);
    const auto setting = setting_of(entry, *option);
    if (setting && open(entry.key)) settings.push_back(*setting);
    decided.push_back(entry.key);
  }
  if (chosen.empty()) return settings;
  const auto known =
      std::find_if(presets.begin(), presets.end(), [&](const auto& candidate) { return candidate.first == chosen; });
  if (known == presets.end()) {
    throw InputError(
        fmt::format("{} {}: there is no such preset; there are {}", chosen_by, chosen, joined(preset_names())));
  }
  for (const auto& [name, value] : known->second) {
    const bool on_paper = name == "size" && !open("width-mm");  // has its size in millimetres
    if (open(name) && !on_paper && find(options, name)) settings.push_back({name, value, false, "preset " + chosen});
  }
  return settings;
}

}  // namespace packstone::cli
