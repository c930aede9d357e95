// No tangential force: no rotation, no history.
#pragma once

#include <array>

#include "engine/contact/normal_force.hpp"

namespace packstone::engine {

struct Frictionless {
  static constexpr bool active = false;
  static constexpr int most_kept = 0;
  static constexpr int kept() { return most_kept; }

  template <class T>
  struct Parameters {
    static constexpr int count = 0;
    std::array<T, count> values() const { return {}; }
    template <class Source>
    static Parameters from(Source&&) {
      return {};
    }
  };

  template <class T>
  using Coefficients = Parameters<T>;
  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Parameters<T>&, const PairSize<T>& /*size*/) {
    return {};
  }
};

}  // namespace packstone::engine
