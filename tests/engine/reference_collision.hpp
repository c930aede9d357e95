// A head-on collision as an ordinary differential equation, m xi'' = -F(xi, xi'), to about 1e-12: what the engine's
// steps are held against. The laws are written out where it is used, apart from the engine's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace packstone::engine::testing {

struct ReferenceCollision {
  double restitution = 0;
  double duration = 0;         ///< [s]
  double largest_overlap = 0;  ///< [m]
};

/// Force [N] on each body at an overlap [m] and its rate [m/s].
using ForceLaw = std::function<double(double overlap, double rate)>;

/// Integrates from first touch until the overlap is back at zero, or until the force is, whichever the contact ends
/// with. Dormand and Prince's fifth-order pair with step control.
class CollisionIntegrator {
 public:
  CollisionIntegrator(ForceLaw force, double mass, bool ends_with_force)
      : force_(std::move(force)), mass_(mass), ends_with_force_(ends_with_force) {}

  /// scale: an overlap of the collision's order [m].
  ReferenceCollision run(double speed, double scale) const {
    ReferenceCollision result;
    State state{0, speed};
    double time = 0, step = 1e-6 * scale / speed;
    constexpr double tolerance = 1e-14;
    for (;;) {
      double error = 0;
      const State next = stepped(state, step, scale, speed, error);
      if (error > tolerance) {
        step *= std::max(0.2, 0.9 * std::pow(tolerance / error, 0.2));
        continue;
      }
      if (state[1] > 0 && next[1] <= 0) {  // the turning point, for the largest overlap
        const double at = crossing(state, step, scale, speed, [](const State& s) { return s[1]; });
        double unused = 0;
        result.largest_overlap = stepped(state, at, scale, speed, unused)[0];
      }
      const auto still = [&](const State& s) {
        return ends_with_force_ && s[1] < 0 ? std::min(s[0], force_(std::max(s[0], 0.0), s[1]) / (force_scale(scale)))
                                            : s[0];
      };
      if (next[1] < 0 && still(next) <= 0) {
        const double at = crossing(state, step, scale, speed, still);
        double unused = 0;
        const State end = stepped(state, at, scale, speed, unused);
        result.duration = time + at;
        result.restitution = -end[1] / speed;
        return result;
      }
      state = next;
      time += step;
      step *= std::min(4.0, 0.9 * std::pow(tolerance / std::max(error, 1e-20), 0.2));
    }
  }

 private:
  using State = std::array<double, 2>;  // overlap, its rate

  double force_scale(double scale) const { return std::abs(force_(scale, 0)) / scale; }

  State slope(const State& s) const { return {s[1], -force_(std::max(s[0], 0.0), s[1]) / mass_}; }

  State stepped(const State& s, double h, double scale, double speed, double& error) const {
    static constexpr double a[7][6] = {{},
                                       {1.0 / 5},
                                       {3.0 / 40, 9.0 / 40},
                                       {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                       {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                       {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                       {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    static constexpr double fourth[7] = {5179.0 / 57600, 0,       7571.0 / 16695, 393.0 / 640, -92097.0 / 339200,
                                         187.0 / 2100,   1.0 / 40};
    State k[7], end = s;
    for (int i = 0; i < 7; ++i) {
      end = s;
      for (int j = 0; j < i; ++j) {
        for (int c = 0; c < 2; ++c) end[c] += h * a[i][j] * k[j][c];
      }
      k[i] = slope(end);
    }
    State other = s;
    for (int j = 0; j < 7; ++j) {
      for (int c = 0; c < 2; ++c) other[c] += h * fourth[j] * k[j][c];
    }
    error = std::max(std::abs(end[0] - other[0]) / scale, std::abs(end[1] - other[1]) / speed);
    return end;
  }

  /// Part of a step after which a function of the state passes from above 0 to below.
  template <class Function>
  double crossing(const State& s, double h, double scale, double speed, const Function& f) const {
    double low = 0, high = h, unused = 0;
    for (int halving = 0; halving < 200 && high - low > 0; ++halving) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      (f(stepped(s, middle, scale, speed, unused)) > 0 ? low : high) = middle;
    }
    return low;
  }

  ForceLaw force_;
  double mass_;
  bool ends_with_force_;
};

}  // namespace packstone::engine::testing
