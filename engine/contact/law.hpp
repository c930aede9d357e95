// What contact laws share: parameters that are plain numbers, so that tables can hold them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "engine/contact/normal_force.hpp"

namespace packstone::engine {

/// A law's parameters, an aggregate of `count` numbers, from parameter(k) in the order of their declaration.
template <class Parameters, class Source>
[[gnu::always_inline]] inline Parameters parameters_from(const Source& parameter) {
  return [&]<std::size_t... k>(std::index_sequence<k...>) __attribute__((always_inline)) {
    return Parameters{parameter(static_cast<int>(k))...};
  }
  (std::make_index_sequence<Parameters::count>{});
}

/// The other way round.
template <class Parameters>
std::array<double, Parameters::count> numbers_of(const Parameters& parameters) {
  if constexpr (Parameters::count > 0) {
    return std::bit_cast<std::array<double, Parameters::count>>(parameters);
  } else {
    return {};
  }
}

/// A law into which neither masses nor radii enter: its coefficients are its parameters.
struct WithoutSizes {
  template <class Parameters, class T>
  [[gnu::always_inline]] static Parameters coefficients(const Parameters& pair, const PairSize<T>& /*size*/) {
    return pair;
  }
};

/// A law that is chosen once a run, with room for the most parameters that any of them has.
template <int most_parameters>
struct ChosenLaw {
  template <class T>
  struct Parameters {
    static constexpr int count = most_parameters;
    std::array<T, count> numbers;
  };

  template <class T>
  struct Coefficients {
    Parameters<T> pair;
    PairSize<T> size;
  };
  template <class T>
  [[gnu::always_inline]] static Coefficients<T> coefficients(const Parameters<T>& pair, const PairSize<T>& size) {
    return {pair, size};
  }

 protected:
  /// The chosen law's own coefficients.
  template <class Law, class T>
  [[gnu::always_inline]] static auto own(const Coefficients<T>& chosen) {
    const auto number = [&](int k) { return chosen.pair.numbers[static_cast<std::size_t>(k)]; };
    return Law::coefficients(parameters_from<typename Law::template Parameters<T>>(number), chosen.size);
  }
};

}  // namespace packstone::engine
