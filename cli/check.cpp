// packstone check: what a scene would run, without running it.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/formats/text_output.hpp"
#include "core/scene.hpp"
#include "engine/scene_check.hpp"

namespace packstone::cli {

namespace {

using engine::SceneCheck;
using nlohmann::ordered_json;

struct CheckOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;
  std::filesystem::path minimal;
  std::vector<std::string> keep;
  bool json = false;
};

ordered_json as_json(const SceneCheck& c) {
  const auto value = [](double number, const char* unit) { return ordered_json{{"value", number}, {"unit", unit}}; };
  ordered_json pairs = ordered_json::array();
  for (const auto& p : c.pairs) {
    pairs.push_back({{"pair", p.pair},
                     {"effective_mass", value(p.effective_mass, "kg")},
                     {"contact_time", value(p.impact.duration, "s")},
                     {"restitution", value(p.impact.restitution, "")},
                     {"largest_overlap", value(p.overlap_share, "radius")},
                     {"steps", value(p.steps, "")}});
  }
  ordered_json simpler = ordered_json::array();
  for (const auto& s : c.simplifications) {
    simpler.push_back({{"key", s.key}, {"to", s.to}, {"why", s.why}, {"loss", s.loss}, {"gain", s.gain}});
  }
  ordered_json j = {
      {"particles", c.particles},
      {"mass", value(c.mass, "kg")},
      {"solid_volume", value(c.solid_volume, "m3")},
      {"domain", {{"value", {c.size[0], c.size[1], c.size[2]}}, {"unit", "m"}}},
      {c.overdamped ? "look_interval" : "time_step", value(c.time_step, "s")},
      {"time_step_limit", value(c.limit.limit, "s")},
      {"time_step_recommended", value(c.limit.recommended, "s")},
      {"tightest_pair", c.limit.pair},
      {"steps", c.steps},
      {"reference_speed", value(c.reference_speed, "m/s")},
      {"pairs", pairs},
      {"memory", value(c.memory, "byte")},
      {"snapshots", c.snapshots},
      {"disk", value(c.disk, "byte")},
      {"loop_time", value(c.seconds, "s")},
      {"warnings", c.warnings},
      {"advice", c.advice},
      {"simplifications", simpler},
  };
  if (c.overdamped) {
    j["integrator"] = c.integrator;
    j["relaxation_time"] = value(c.overdamped->contact_time, "s");
    j["stiffness_ratio"] = value(c.overdamped->stiffness_ratio, "");
    j["sinking_speed"] = value(c.overdamped->sinking_speed, "m/s");
    for (const char* of_impacts : {"reference_speed", "pairs", "loop_time"}) j.erase(of_impacts);
  }
  if (c.way) {
    j["way"] = {{"stiffness_factor", value(c.way->factor, "")},
                {"time_step", value(c.way_step, "s")},
                {"resting_overlap", value(c.way->resting_overlap, "radius")},
                {"impact_overlap", value(c.way->impact_overlap, "radius")}};
  }
  if (c.resting_overlap) j["resting_overlap"] = value(*c.resting_overlap, "radius");
  if (c.bond_number) j["bond_number"] = value(*c.bond_number, "");
  if (c.sticking_speed) j["sticking_speed"] = value(*c.sticking_speed, "m/s");
  return j;
}

std::string size_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string time_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.2g} s", seconds);
  return seconds < 6000 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

void line(const char* name, const std::string& text) { fmt::print("{:<18}{}\n", name, text); }

void print_overdamped(const SceneCheck& c) {
  const engine::OverdampedScales& scales = *c.overdamped;
  line("overdamped",
       fmt::format("t_0 = mu/k = {:.3g} s ({}), chi = k r/weight = {:.3g}, a free sphere sinks at {:.3g} m/s",
                   scales.contact_time, scales.pair, scales.stiffness_ratio, scales.sinking_speed));
  line("integrator", c.integrator);
  line("explicit Euler", fmt::format("steps up to about {:.3g} s in a bed, {:.3g} s with one contact", scales.bed_limit,
                                     scales.single_limit));
  line("looked at", fmt::format("every {:.3g} s, {} times", c.time_step, c.steps));
}

void print_impacts(const SceneCheck& c) {
  fmt::print("\nimpact at {:.3g} m/s{:>22}{:>14}{:>14}{:>14}\n", c.reference_speed, "contact time", "restitution",
             "overlap [R]", "steps");
  for (const auto& p : c.pairs) {
    fmt::print("  {:<24}{:>12.4g} us{:>14.4f}{:>14.2g}{:>14.1f}\n", p.pair, p.impact.duration * 1e6,
               p.impact.restitution, p.overlap_share, p.steps);
  }
}

void print_text(const SceneCheck& c) {
  line("particles", fmt::format("{}, {:.4g} kg, {:.4g} m3 of solid", c.particles, c.mass, c.solid_volume));
  line("domain", fmt::format("{:.4g} x {:.4g} x {:.4g} m", c.size[0], c.size[1], c.size[2]));
  if (c.overdamped) {
    print_overdamped(c);
  } else {
    line("time step", fmt::format("{:.3g} us, {} steps; recommended {:.3g} us, limit {:.3g} us ({})", c.time_step * 1e6,
                                  c.steps, c.limit.recommended * 1e6, c.limit.limit * 1e6, c.limit.pair));
  }
  if (c.way) {
    const std::string soft = fmt::format(
        "{:.3g} of the stiffness, {}overlaps up to {:.2g} % of the radius under the bed's weight", c.way->factor,
        c.overdamped ? "" : fmt::format("{:.3g} us steps, ", 1e6 * c.way_step), 100 * c.way->resting_overlap);
    const std::string falls = fmt::format(" and {:.2g} % in falls", 100 * c.way->impact_overlap);
    line("way to rest", soft + (c.overdamped ? "" : falls) + "; then full stiffness");
  }
  if (c.resting_overlap) line("overlap at rest", fmt::format("{:.2g} % of the radius", 100 * *c.resting_overlap));
  if (c.bond_number) line("Bond number", fmt::format("{:.3g}", *c.bond_number));
  if (c.sticking_speed) line("sticks below", fmt::format("{:.3g} m/s", *c.sticking_speed));
  line("cost, about", fmt::format("{} of memory, {} in {} snapshots{}", size_text(c.memory), size_text(c.disk),
                                  c.snapshots, c.overdamped ? "" : ", " + time_text(c.seconds) + " on two cores"));
  if (!c.overdamped) print_impacts(c);
  for (const auto& text : c.warnings) fmt::print("\nwarning: {}\n", text);
  for (const auto& text : c.advice) fmt::print("\nadvice: {}\n", text);
  if (!c.simplifications.empty()) fmt::print("\nwhat it could do without (--minimal FILE applies it)\n");
  for (const auto& s : c.simplifications) {
    fmt::print("  {}: {}; {}\n    loss: {}\n    gain: {}\n", s.key, s.to, s.why, s.loss, s.gain);
  }
}

/// The simpler scene, with what was changed and why above it.
void write_minimal(const CheckOptions& options, const Scene& scene, const SceneCheck& check) {
  std::string head = fmt::format("# Simplified from {} by packstone check --minimal:\n", options.scene.string());
  for (const auto& s : check.simplifications) {
    const bool kept = std::find(options.keep.begin(), options.keep.end(), s.key) != options.keep.end();
    head += kept ? fmt::format("# {} kept, which could be {}\n", s.key, s.to)
                 : fmt::format("# {}: {}; {}. Loss: {}\n", s.key, s.to, s.why, s.loss);
  }
  formats::TextOutput file(options.minimal);
  file.print("{}\n{}", head, to_toml(engine::simplified(scene, check.simplifications, options.keep)));
  file.finish();
}

void check(const CheckOptions& options) {
  const Scene scene = read_scene(options.scene, options.overrides);
  const SceneCheck result = engine::check_scene(scene);
  for (const std::string& key : options.keep) {
    if (std::none_of(result.simplifications.begin(), result.simplifications.end(),
                     [&](const auto& s) { return s.key == key; })) {
      throw InputError(fmt::format("--keep {}: nothing would be changed there", key));
    }
  }
  std::error_code none_there;
  if (std::filesystem::equivalent(options.minimal, options.scene, none_there)) {
    throw InputError(fmt::format("--minimal {}: is the scene itself; name another file", options.minimal.string()));
  }
  if (!options.minimal.empty()) {
    check_writable(options.minimal);
    write_minimal(options, scene, result);
  }
  if (options.json) {
    fmt::print("{}\n", as_json(result).dump(2));
  } else {
    print_text(result);
  }
}

}  // namespace

void add_check(Program& program) {
  auto options = std::make_shared<CheckOptions>();
  Verb verb = program.add_verb("check", "Tell what a scene would run: contacts, step, cost, advice; no run");
  verb.add("scene", options->scene, "Scene file (TOML)").required();
  verb.add("--set", options->overrides, "Override a key of the scene, KEY=VALUE; may be repeated").one_at_a_time();
  verb.add("--minimal", options->minimal,
           "Write the scene without what it could do without, every change with its loss in a comment");
  verb.add("--keep", options->keep, "Keys that --minimal leaves as they are, by comma").by_comma();
  verb.add_flag("--json", options->json, "As JSON");
  verb.set_action([options] { check(*options); });
}

}  // namespace packstone::cli
