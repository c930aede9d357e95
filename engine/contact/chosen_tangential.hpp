// Any tangential law, chosen once a run, as in chosen_normal.hpp.
#pragma once

#include <array>

#include "core/scene.hpp"
#include "engine/contact/coulomb.hpp"
#include "engine/contact/cundall_strack.hpp"
#include "engine/contact/haff_werner.hpp"
#include "engine/contact/mindlin_deresiewicz.hpp"
#include "engine/contact/tangential_force.hpp"
#include "engine/contact/walton_braun_tangential.hpp"

namespace packstone::engine {

class ChosenTangential {
 public:
  static constexpr bool active = true;
  static constexpr int most_kept = MindlinDeresiewicz::most_kept;

  /// For scenes with friction.
  explicit ChosenTangential(const ContactSpec& contact) : model_(contact.tangential) {}

  /// use(law); returns what it does.
  template <class Use>
  [[gnu::always_inline]] auto with_law(const Use& use) const {
    switch (model_) {
      case TangentialModel::coulomb:
        return use(Coulomb{});
      case TangentialModel::haff_werner:
        return use(HaffWerner{});
      case TangentialModel::mindlin_deresiewicz:
        return use(MindlinDeresiewicz{});
      case TangentialModel::walton_braun:
        return use(WaltonBraunTangential{});
      case TangentialModel::none:
      case TangentialModel::cundall_strack:
        break;
    }
    return use(CundallStrack{});
  }

  int kept() const {
    return with_law([](auto law) { return decltype(law)::most_kept; });
  }

  template <class T>
  struct Parameters {
    static constexpr int count = 2;  ///< the most that a law has
    std::array<T, count> numbers;

    std::array<T, count> values() const { return numbers; }
    template <class Source>
    static Parameters from(Source&& parameter) {
      return {{parameter(0), parameter(1)}};
    }
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

  template <class T, class Kept>
  [[gnu::noinline]] TangentialForce<T> advance(const Coefficients<T>& pair, const Slip<T>& slip, Kept& kept) const {
    return with_law([&](auto law) __attribute__((always_inline)) {
      using Law = decltype(law);
      using OwnParameters = typename Law::template Parameters<T>;
      const auto parameters =
          OwnParameters::from([&](int k) { return pair.pair.numbers[static_cast<std::size_t>(k)]; });
      return Law::advance(Law::coefficients(parameters, pair.size), slip, kept);
    });
  }

 private:
  TangentialModel model_;
};

}  // namespace packstone::engine
