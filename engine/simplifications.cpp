#include "engine/simplifications.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "engine/dynamics/step.hpp"
#include "engine/force_resolution.hpp"
#include "engine/rest/softening.hpp"
#include "engine/scene_check.hpp"
#include "engine/simulation.hpp"

namespace packstone::engine {

namespace {

constexpr double negligible_bond_number = 0.01;
constexpr double wanted_overlap = 0.005;      ///< of the radius: what a softened contact may have
constexpr double least_softening = 2;         ///< worth a word
constexpr double negligible_rounding = 0.01;  ///< of the weight
constexpr double much_on_disk = 1e9;          ///< [bytes]

std::optional<Simplification> without_attraction(const SceneCheck& check) {
  if (!check.bond_number || *check.bond_number >= negligible_bond_number) return std::nullopt;
  return Simplification{"contact.van_der_waals",
                        "left out",
                        fmt::format("the Bond number is {:.2g}", *check.bond_number),
                        fmt::format("forces of {:.2g} of a weight", *check.bond_number),
                        "shorter lists of neighbours, longer steps",
                        [](Scene& s) { s.contact.van_der_waals = {}; }};
}

std::optional<Simplification> without_friction_law(const Scene& scene) {
  if (scene.contact.tangential == TangentialModel::none || rotates(scene)) return std::nullopt;
  return Simplification{
      "contact.tangential", "\"none\"", "all friction is 0", "none", "none: it costs nothing as it is", [](Scene& s) {
        s.contact.tangential = TangentialModel::none;
      }};
}

/// A bed that is run until it rests is wanted for itself.
std::optional<Simplification> only_rest(const Scene& scene) {
  const DynamicsSpec& d = scene.dynamics;
  const ContactSpec& c = scene.contact;
  if (d.goal == Goal::rest || !d.rest_speed || d.overdamped() || rotates(scene) || c.van_der_waals.present ||
      c.normal == NormalModel::walton_braun || !scene.gravity.present || scene.gravity.end ||
      !scene.gravity.formula.empty() ||
      std::any_of(scene.boundaries.begin(), scene.boundaries.end(), [](const auto& b) { return b.motion.present; })) {
    return std::nullopt;
  }
  return Simplification{"dynamics.goal",
                        "\"rest\"",
                        "the run is to end at rest, nothing rubs or sticks, and no wall moves",
                        "the motion before; packing fraction within 0.003, docs/tradeoff.md",
                        "2 to 50 times quicker, docs/tradeoff.md",
                        [](Scene& s) {
                          s.dynamics.goal = Goal::rest;
                          if (!s.dynamics.way_overlap) s.dynamics.way_overlap = DynamicsSpec::default_way_overlap;
                          if (!s.dynamics.way_energy) s.dynamics.way_energy = DynamicsSpec::default_way_energy;
                          if (!s.dynamics.unbalanced_force)
                            s.dynamics.unbalanced_force = DynamicsSpec::default_unbalanced_force;
                        }};
}

std::optional<Simplification> softer(const Scene& scene, const SceneCheck& check) {
  if (scene.dynamics.goal == Goal::rest || scene.contact.van_der_waals.present) return std::nullopt;
  double deepest = check.resting_overlap.value_or(0);
  for (const PairCheck& pair : check.pairs) deepest = std::max(deepest, pair.overlap_share);
  // Overlaps go as stiffness^(-1/2) in impacts of springs, ^(-2/5) of Hertz' contacts; steps as stiffness^(-1/2).
  // Under a load as stiffness^-1 or ^(-2/3).
  const bool hertzian = is_hertzian(scene.contact.normal);
  const double power = check.overdamped ? (hertzian ? 1.5 : 1.0) : (hertzian ? 2.5 : 2.0);
  const double times = std::pow(wanted_overlap / std::max(deepest, 1e-12), power);
  if (deepest == 0 || times < least_softening) return std::nullopt;
  return Simplification{
      hertzian ? "young_modulus" : "normal_stiffness",
      fmt::format("{:.3g} times less", times),
      fmt::format("overlaps stay below {:.2g} % of the radius", 100 * deepest),
      fmt::format("overlaps of up to {:g} % of the radius", 100 * wanted_overlap),
      check.overdamped ? "less to solve for" : fmt::format("steps {:.2g} times as long", std::sqrt(times)),
      [times](Scene& s) {
        s = softened(std::move(s), 1 / times);
        if (s.dynamics.time_step && !s.dynamics.overdamped()) *s.dynamics.time_step *= std::sqrt(times);
      }};
}

std::optional<Simplification> longer_step(const Scene& scene, const SceneCheck& check) {
  if (check.overdamped || !scene.dynamics.time_step || check.time_step >= 0.5 * check.limit.recommended) {
    return std::nullopt;
  }
  return Simplification{"dynamics.time_step",
                        "\"auto\"",
                        fmt::format("{:.3g} us is what is recommended", 1e6 * check.limit.recommended),
                        "errors of a few per cent in a collision, docs/physics.md",
                        fmt::format("{:.2g} times fewer steps", check.limit.recommended / check.time_step),
                        [](Scene& s) { s.dynamics.time_step.reset(); }};
}

std::optional<Simplification> single_precision(const Scene& scene, const Simulation& simulation) {
  if (scene.dynamics.precision == Precision::mixed || scene.dynamics.overdamped() || !scene.gravity.present)
    return std::nullopt;
  const double share = rounding_over_weight(scene, simulation.population());
  if (share > negligible_rounding) return std::nullopt;
  return Simplification{"dynamics.precision",
                        "\"mixed\"",
                        "positions are in fixed point, so that only forces are rounded",
                        fmt::format("forces rounded by {:.1g} of a weight", share),
                        "less memory to read in a step, docs/performance.md",
                        [](Scene& s) { s.dynamics.precision = Precision::mixed; }};
}

std::optional<Simplification> without_contacts(const Scene& scene, const SceneCheck& check) {
  const double share = disk_of_contacts(scene, check);
  if (!scene.output.contacts || share < much_on_disk) return std::nullopt;
  return Simplification{"output.contacts",
                        "false",
                        fmt::format("they take {:.2g} of {:.2g} GB of snapshots", 1e-9 * share, 1e-9 * check.disk),
                        "force chains, stresses and exact contact forces",
                        "smaller snapshots",
                        [](Scene& s) { s.output.contacts = false; }};
}

}  // namespace

std::vector<Simplification> simplifications(const Scene& scene, const Simulation& simulation, const SceneCheck& check) {
  const auto rest = only_rest(scene);
  std::vector<Simplification> all;
  for (const auto& found :
       {without_attraction(check), without_friction_law(scene), rest, rest ? std::nullopt : softer(scene, check),
        longer_step(scene, check), single_precision(scene, simulation), without_contacts(scene, check)}) {
    if (found) all.push_back(*found);
  }
  return all;
}

Scene simplified(Scene scene, const std::vector<Simplification>& all, const std::vector<std::string>& kept) {
  for (const Simplification& one : all) {
    if (std::find(kept.begin(), kept.end(), one.key) == kept.end()) one.apply(scene);
  }
  return scene;
}

}  // namespace packstone::engine
