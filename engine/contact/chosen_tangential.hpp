// Any tangential law, chosen once a run, as in chosen_normal.hpp.
#pragma once

#include <array>

#include "core/scene.hpp"
#include "engine/contact/coulomb.hpp"
#include "engine/contact/cundall_strack.hpp"
#include "engine/contact/haff_werner.hpp"
#include "engine/contact/law.hpp"
#include "engine/contact/mindlin_deresiewicz.hpp"
#include "engine/contact/tangential_force.hpp"
#include "engine/contact/walton_braun_tangential.hpp"

namespace packstone::engine {

class ChosenTangential : public ChosenLaw<2> {
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

  template <class T, class Kept>
  [[gnu::noinline]] TangentialForce<T> advance(const Coefficients<T>& pair, const Slip<T>& slip, Kept& kept) const {
    return with_law([&](auto law) __attribute__((always_inline)) {
      return decltype(law)::advance(own<decltype(law)>(pair), slip, kept);
    });
  }

 private:
  TangentialModel model_;
};

}  // namespace packstone::engine
