#include "analysis/forces/friction.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/scene.hpp"

namespace packstone::analysis {

namespace {

/// Friction of the material of that name; false where the scene has none.
bool append_friction(std::vector<double>& friction, const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.materials.begin(), scene.materials.end(), [&](const auto& m) { return m.name == name; });
  if (found == scene.materials.end()) return false;
  friction.push_back(found->friction);
  return true;
}

bool append_boundary(std::vector<double>& friction, const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.boundaries.begin(), scene.boundaries.end(), [&](const auto& b) { return b.name == name; });
  return found != scene.boundaries.end() && append_friction(friction, scene, found->material);
}

}  // namespace

double FrictionTable::coefficient(const Snapshot& snapshot, const ForceContact& contact, std::size_t row) const {
  const auto of = [&](std::uint32_t particle) {
    return material[static_cast<std::size_t>(snapshot.material[particle])];
  };
  const double other =
      contact.at_wall() ? boundary[static_cast<std::size_t>(-1 - snapshot.contacts->second[row])] : of(contact.second);
  return std::sqrt(of(contact.first) * other);
}

FrictionTable friction_table(const Snapshot& snapshot) {
  FrictionTable table;
  if (snapshot.scene_text.empty()) {
    table.missing = "the snapshot carries no scene that gives coefficients of friction";
    return table;
  }
  try {
    const Scene scene = parse_scene(snapshot.scene_text, "scene of the snapshot");
    bool complete = true;
    for (const auto& name : snapshot.material_names) complete &= append_friction(table.material, scene, name);
    for (const auto& b : snapshot.boundaries) complete &= append_boundary(table.boundary, scene, b.name);
    const auto known = [&](std::int32_t m) {
      return m >= 0 && static_cast<std::size_t>(m) < snapshot.material_names.size();
    };
    complete &= snapshot.material.size() == snapshot.size() &&
                std::all_of(snapshot.material.begin(), snapshot.material.end(), known);
    if (!complete) table.missing = "the snapshot's scene does not name all its materials and boundaries";
    if (scene.contact.tangential == TangentialModel::none) table.missing = "the scene's contacts have no friction";
  } catch (const InputError&) {
    table.missing = "the scene that the snapshot carries cannot be read";
  }
  return table;
}

}  // namespace packstone::analysis
