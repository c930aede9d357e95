#include "cli/study/variants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/text_lines.hpp"
#include "engine/rest/softening.hpp"
#include "engine/simulation.hpp"

namespace packstone::cli {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Parts between separators that stand outside of brackets and quotes.
std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == separator && depth == 0 && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

/// Without the quotes around it and the table before the key.
std::string short_label(const std::string& key, std::string value) {
  std::erase(value, '"');
  const auto dot = key.find_last_of('.');
  return (dot == std::string::npos ? key : key.substr(dot + 1)) + " " + value;
}

}  // namespace

std::pair<std::string, std::string> setting_of(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw InputError(
        fmt::format("\"{}\" is no variant; KEY=V1,V2,... or \"NAME: KEY=VALUE; KEY=VALUE\" would be", text));
  }
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1))};
}

double factor_of(const std::string& key, const std::string& value) {
  const std::optional<double> number = parsed_number(value);
  if (!number || !(*number > 0) || !std::isfinite(*number)) {
    throw InputError(fmt::format("{}={}: is no factor; a number above 0 would be", key, value));
  }
  return *number;
}

std::vector<Variant> variants_of(const std::string& text) {
  const auto colon = parts_of(text, ':');
  if (colon.size() == 2 && colon.front().find('=') == std::string::npos) {
    Variant variant{colon.front(), parts_of(colon.back(), ';')};
    for (const std::string& setting : variant.settings) setting_of(setting);
    return {variant};
  }
  const auto [key, values] = setting_of(text);
  std::vector<Variant> variants;
  for (const std::string& value : parts_of(values, ',')) {
    variants.push_back({short_label(key, value), {key + "=" + value}});
  }
  return variants;
}

std::vector<Variant> usual_variants() {
  std::vector<Variant> variants = {{as_is, {}}};
  for (const char* text :
       {"step=0.5,1,2", "stiffness=0.1,0.01", "dynamics.precision=\"mixed\"", "dynamics.goal=\"rest\""}) {
    const auto more = variants_of(text);
    variants.insert(variants.end(), more.begin(), more.end());
  }
  return variants;
}

Scene scene_of(const std::filesystem::path& file, const std::vector<std::string>& overrides, const Variant& variant,
               std::int64_t seed) {
  std::vector<std::string> keys = overrides;
  double stiffness = 1;
  std::optional<double> step;
  for (const std::string& setting : variant.settings) {
    const auto [key, value] = setting_of(setting);
    if (key == "stiffness") {
      stiffness = factor_of(key, value);
    } else if (key == "step") {
      step = factor_of(key, value);
      keys.emplace_back("dynamics.time_step=\"auto\"");
    } else {
      keys.push_back(setting);
    }
  }
  keys.push_back(fmt::format("seed={}", seed));
  Scene scene = read_scene(file, keys);
  if (stiffness != 1) {
    scene = engine::softened(std::move(scene), stiffness);
    if (scene.dynamics.time_step) *scene.dynamics.time_step /= std::sqrt(stiffness);
  }
  if (step) scene.dynamics.time_step = *step * engine::Simulation(scene).step_limit().recommended;
  return scene;
}

}  // namespace packstone::cli
