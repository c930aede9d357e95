// What a scene says about particles that another program moved.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "core/snapshot.hpp"

namespace packstone::cli {

/// Gives snapshots of other programs the domain, materials, groups, boundaries and gravity of a scene.
class LikeScene {
 public:
  /// Throws InputError as read_scene does.
  explicit LikeScene(const std::filesystem::path& path);

  double time_step() const { return scene_.dynamics.time_step.value_or(0); }  ///< [s]; 0: the scene does not say

  /// The snapshot's groups become the scene's, one after the other; boundaries stand where they do at the beginning.
  /// Notes on what the file left open and the scene says are dropped.
  /// Throws InputError that names the source when a particle's group is not in the scene, or its centre lies more
  /// than the domain's length outside.
  void apply(Snapshot& snapshot, const std::string& source) const;

 private:
  Scene scene_;
  Domain domain_;
  std::vector<BoundaryRecord> boundaries_;
};

}  // namespace packstone::cli
