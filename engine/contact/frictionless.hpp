// No tangential force: no rotation, no history.
#pragma once

namespace packstone::engine {

struct Frictionless {
  static constexpr bool active = false;
  struct Pair {};
};

}  // namespace packstone::engine
