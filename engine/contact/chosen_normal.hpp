// Any normal law, with or without attraction, chosen once a run.
#pragma once

#include <array>

#include "core/scene.hpp"
#include "engine/contact/hertz.hpp"
#include "engine/contact/hysteretic.hpp"
#include "engine/contact/kuwabara_kono.hpp"
#include "engine/contact/law.hpp"
#include "engine/contact/linear.hpp"
#include "engine/contact/normal_force.hpp"
#include "engine/contact/van_der_waals.hpp"
#include "engine/contact/walton_braun.hpp"
#include "engine/simd/scalar.hpp"

namespace packstone::engine {

/// One loop over contacts for all laws: it branches once for all lanes, the same way throughout a run. Compiling every
/// pair of laws into a loop of its own would take a quarter of an hour; that is also why the laws are called, not
/// inlined (docs/performance.md).
class ChosenNormal : public ChosenLaw<3> {
 public:
  static constexpr int most_kept = WaltonBraun::most_kept;
  static constexpr bool plastic = true;
  static constexpr bool attracts = true;

  explicit ChosenNormal(const ContactSpec& contact)
      : model_(contact.normal),
        ends_with_force_(contact.release == Release::zero_force),
        attraction_(contact.van_der_waals) {}

  const VanDerWaals& attraction() const { return attraction_; }

  /// use(law), with a law whose contact ends with the overlap; returns what it does.
  template <class Use>
  [[gnu::always_inline]] auto with_law(const Use& use) const {
    switch (model_) {
      case NormalModel::hertz:
        return use(Hertz{});
      case NormalModel::kuwabara_kono:
        return use(KuwabaraKono{});
      case NormalModel::walton_braun:
        return use(WaltonBraun{});
      case NormalModel::hysteretic:
        return use(Hysteretic{});
      case NormalModel::linear:
        break;
    }
    return use(Linear<Release::zero_overlap>{});
  }

  int kept() const {
    return with_law([](auto law) { return decltype(law)::most_kept; });
  }

  /// overlap [m] > 0; rate of overlap [m/s].
  template <class T, class Kept>
  [[gnu::noinline]] NormalForce<T> force(const Coefficients<T>& pair, const T& overlap, const T& rate,
                                         Kept& kept) const {
    using simd::larger;
    NormalForce<T> f = with_law([&](auto law) __attribute__((always_inline)) {
      return decltype(law)::force(own<decltype(law)>(pair), overlap, rate, kept);
    });
    if (ends_with_force_) f.damping = larger(f.damping, -f.elastic);
    return f;
  }

  /// Stored energy [J].
  template <class T, class Kept>
  [[gnu::noinline]] T energy(const Coefficients<T>& pair, const T& overlap, const Kept& kept) const {
    return with_law([&](auto law) __attribute__((always_inline)) {
      return decltype(law)::energy(own<decltype(law)>(pair), overlap, kept);
    });
  }

 private:
  NormalModel model_;
  bool ends_with_force_;
  VanDerWaals attraction_;
};

}  // namespace packstone::engine
