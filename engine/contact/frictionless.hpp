// No tangential force: no rotation, no history.
#pragma once

#include <array>

namespace packstone::engine {

struct Frictionless {
  static constexpr bool active = false;

  template <class T>
  struct Parameters {
    static constexpr int count = 0;
    std::array<T, count> values() const { return {}; }
    template <class Source>
    static Parameters from(Source&&) {
      return {};
    }
  };
};

}  // namespace packstone::engine
