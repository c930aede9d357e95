// Where the particles are when a run begins, whatever put them there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/vec3.hpp"

namespace packstone::engine {

/// All particles at time 0, ordered by id.
struct StartingState {
  std::vector<Vec3> position;          ///< [m]
  std::vector<Vec3> velocity;          ///< [m/s]
  std::vector<Vec3> angular_velocity;  ///< [rad/s]
  std::vector<double> radius;          ///< at full size [m]
  std::vector<std::int32_t> type;      ///< [[particles]] entry
  std::string source_hash;             ///< content_hash of the file they came from; empty for growth

  std::size_t size() const { return position.size(); }
};

}  // namespace packstone::engine
