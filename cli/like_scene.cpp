#include "cli/like_scene.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "engine/boundary/boundaries.hpp"

namespace packstone::cli {

LikeScene::LikeScene(const std::filesystem::path& path)
    : scene_(read_scene(path)), domain_(scene_.box()), boundaries_(engine::Boundaries(scene_, domain_).records()) {}

void LikeScene::apply(Snapshot& s, const std::string& source) const {
  const Vec3 size = domain_.size();
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (static_cast<std::size_t>(s.type[i]) >= scene_.particles.size()) {
      throw InputError(
          fmt::format("{}: particle {} is of type {} (counted from 0), the scene has {} [[particles]]; add "
                      "one for each type",
                      source, s.id[i], s.type[i], scene_.particles.size()));
    }
    const Vec3& p = s.position[i];
    if ((p.array() < (domain_.min - size).array()).any() || (p.array() > (domain_.max + size).array()).any()) {
      throw InputError(
          fmt::format("{}: particle {} at ({:g}, {:g}, {:g}) m lies far outside the scene's domain; lengths "
                      "are in m",
                      source, s.id[i], p.x(), p.y(), p.z()));
    }
    s.position[i] = domain_.wrapped(p);
  }
  s.domain = domain_;
  s.gravity = scene_.gravity.present ? scene_.gravity.acceleration : Vec3::Zero();
  if (s.boundaries.size() > boundaries_.size()) {
    throw InputError(fmt::format(
        "{}: the contacts are with {} walls, the scene has {} [[boundaries]]; wall k is the k-th, add those that "
        "lack",
        source, s.boundaries.size(), boundaries_.size()));
  }
  s.boundaries = boundaries_;
  s.groups.clear();
  s.material_names.clear();
  for (const MaterialSpec& material : scene_.materials) s.material_names.push_back(material.name);
  for (const GroupSpec& group : scene_.particles) {
    const MaterialSpec& material = scene_.materials[static_cast<std::size_t>(scene_.material_index(group.material))];
    s.groups.push_back({group.name, group.material, material.density});
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.material[i] = scene_.material_index(scene_.particles[static_cast<std::size_t>(s.type[i])].material);
  }
  s.scene_text = to_toml(scene_);
  s.scene_hash = scene_hash(scene_);
  std::erase_if(s.notes, [](const std::string& note) {
    return note == note_no_box || note == note_no_density || note == note_no_periodicity || note == note_no_walls;
  });
}

}  // namespace packstone::cli
