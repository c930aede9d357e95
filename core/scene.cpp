#include "core/scene.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/boundary_options.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/geometry.hpp"
#include "core/hash.hpp"
#include "core/options_reader.hpp"
#include "core/scene_checks.hpp"
#include "core/text.hpp"

namespace packstone {

namespace {

/// Where van der Waals' force has fallen to 1e-4 of what it is at the smallest gap.
constexpr double cutoff_over_min_gap = 100;

/// Keys that overdamped motion leaves aside get the values that say so.
void fill_overdamped_defaults(Scene& s) {
  constexpr double default_tolerance = 0.01;
  if (!s.dynamics.tolerance) s.dynamics.tolerance = default_tolerance;
  for (auto& material : s.materials) {
    if (!material.normal_damping && !material.restitution) material.normal_damping = 0;
  }
}

void fill_rest_defaults(DynamicsSpec& d) {
  if (!d.way_overlap) d.way_overlap = DynamicsSpec::default_way_overlap;
  if (d.overdamped()) {
    if (!d.rest_force) d.rest_force = DynamicsSpec::default_way_force;
  } else if (!d.way_energy) {
    d.way_energy = DynamicsSpec::default_way_energy;
  }
  if (!d.unbalanced_force) d.unbalanced_force = DynamicsSpec::default_unbalanced_force;
}

void fill_defaults(Scene& s) {
  if (s.dynamics.overdamped()) fill_overdamped_defaults(s);
  if (s.dynamics.goal == Goal::rest) fill_rest_defaults(s.dynamics);
  if (s.dynamics.duration == 0) {
    for (const StageSpec& stage : s.stages) s.dynamics.duration += stage.duration;
  }
  VanDerWaalsSpec& attraction = s.contact.van_der_waals;
  if (attraction.present && !attraction.cutoff) attraction.cutoff = cutoff_over_min_gap * attraction.min_gap;
  for (auto& group : s.particles) {
    if (group.name.empty()) group.name = group.material;
  }
  for (auto& boundary : s.boundaries) {
    if (boundary.material.empty()) boundary.material = s.materials.front().name;
    fill_defaults(boundary);
  }
}

/// From the root, so that the run folder's copy of the scene finds the files too.
void complete_paths(Scene& s, const std::filesystem::path& folder) {
  const auto complete = [&](const std::string& key, std::optional<std::string>& path) {
    if (!path) return;
    const bool overridden = s.locations.at(key).starts_with("--set");
    const std::filesystem::path base = overridden ? std::filesystem::current_path() : folder;
    path = (base / *path).lexically_normal().string();
  };
  complete("filling.path", s.filling.path);
  for (std::size_t k = 0; k < s.boundaries.size(); ++k) {
    complete(fmt::format("boundary[{}].path", k), s.boundaries[k].path);
    complete(fmt::format("boundary[{}].grid", k), s.boundaries[k].grid);
  }
}

Scene parse_scene_in(const std::filesystem::path& folder, const std::string& text, const std::string& source_name,
                     const std::vector<std::string>& overrides) {
  Scene scene;
  OptionReader reader(text, source_name, overrides, scene.locations);
  describe(reader, scene);
  reader.finish();
  fill_defaults(scene);
  complete_paths(scene, folder);
  check(scene);
  return scene;
}

}  // namespace

void Scene::fail(const std::string& path, const std::string& what) const {
  std::string at = path;
  while (!at.empty() && !locations.count(at)) {
    const std::size_t cut = at.find_last_of(".[");
    at = cut == std::string::npos ? "" : at.substr(0, cut);
  }
  const auto found = locations.find(at);
  throw InputError((found == locations.end() ? "" : found->second + ": ") + path + ": " + what);
}

SizeRange Scene::size_range(std::size_t group) const {
  const GroupSpec& g = particles[group];
  return g.sizes.present ? range_of(g.sizes) : SizeRange{*g.radius, *g.radius};
}

std::vector<double> Scene::radii(std::size_t group) const {
  const GroupSpec& g = particles[group];
  if (g.sizes.present) return drawn_radii(g.sizes, *g.count, static_cast<std::uint64_t>(seed), group);
  return std::vector<double>(static_cast<std::size_t>(*g.count), *g.radius);
}

double Scene::solid_volume() const {
  double total = 0;
  for (std::size_t g = 0; g < particles.size(); ++g) {
    if (!particles[g].count) continue;
    if (particles[g].sizes.present) {
      for (const double radius : radii(g)) total += sphere_volume(radius);
    } else {
      total += static_cast<double>(*particles[g].count) * sphere_volume(*particles[g].radius);
    }
  }
  return total;
}

Domain Scene::box() const {
  Domain box;
  for (int axis : domain.periodic) box.periodic[axis] = true;
  if (domain.volume_factor) {
    box.min.setZero();
    box.max = *domain.aspect * std::cbrt(*domain.volume_factor * solid_volume() / domain.aspect->prod());
  } else {
    box.min = *domain.min;
    box.max = *domain.max;
  }
  return box;
}

int Scene::material_index(const std::string& name) const {
  const auto found = std::find_if(materials.begin(), materials.end(), [&](const auto& m) { return m.name == name; });
  return static_cast<int>(found - materials.begin());
}

Scene parse_scene(const std::string& text, const std::string& source_name, const std::vector<std::string>& overrides) {
  return parse_scene_in(std::filesystem::current_path(), text, source_name, overrides);
}

Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  return parse_scene_in(folder, read_text_file(path), path.string(), overrides);
}

std::string scene_hash(const Scene& scene) { return content_hash(to_toml(scene)); }

}  // namespace packstone
