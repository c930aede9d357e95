// No tangential force: no rotation, no history.
#pragma once

#include "engine/contact/law.hpp"

namespace packstone::engine {

struct Frictionless : WithoutSizes {
  static constexpr bool active = false;
  static constexpr int most_kept = 0;
  static constexpr int kept() { return most_kept; }

  template <class T>
  struct Parameters {
    static constexpr int count = 0;
  };

  template <class T>
  using Coefficients = Parameters<T>;
};

}  // namespace packstone::engine
