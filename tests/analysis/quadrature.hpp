// Numerical integration to nearly the precision of long double, for integrals with singular ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace packstone::fixtures {

/// Tanh-sinh rule (Takahasi and Mori, Publ. RIMS 9 (1974) 721) on one interval without inner singularities.
template <class Function>
long double quadrature(long double from, long double to, const Function& f) {
  if (!(to > from)) return 0;
  constexpr int levels = 128;
  constexpr long double reach = 4.2L, step = reach / levels, half_pi = std::numbers::pi_v<long double> / 2;
  long double sum = 0;
  for (int k = -levels; k <= levels; ++k) {
    const long double t = k * step, u = half_pi * std::sinh(t);
    const long double weight = half_pi * std::cosh(t) / (std::cosh(u) * std::cosh(u));
    // From the nearer end, so that points close to it keep their digits.
    const long double away = (to - from) / (std::exp(2 * std::abs(u)) + 1);
    sum += weight * f(t < 0 ? from + away : to - away);
  }
  return sum * step * (to - from) / 2;
}

/// The same over the pieces between the points where the function is not smooth.
template <class Function>
long double quadrature(long double from, long double to, std::vector<long double> kinks, const Function& f) {
  kinks.push_back(from);
  kinks.push_back(to);
  for (auto& x : kinks) x = std::clamp(x, from, std::max(from, to));
  std::sort(kinks.begin(), kinks.end());
  long double sum = 0;
  for (std::size_t k = 0; k + 1 < kinks.size(); ++k) sum += quadrature(kinks[k], kinks[k + 1], f);
  return sum;
}

}  // namespace packstone::fixtures
