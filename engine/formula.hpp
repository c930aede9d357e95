// A user's formula, as muParser reads it.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "core/scene.hpp"

namespace packstone::engine {

/// Knows pi, floor(x) and mod(x, period) beside muParser's own functions: sin, exp, sqrt, abs, min, max, "t<1 ? a : b" and the like. Not for several
/// threads at a time.
class Formula {
 public:
  /// variables: their names. Throws InputError "\"TEXT\": what is wrong".
  Formula(const std::string& text, const std::vector<std::string>& variables);
  Formula(Formula&&) noexcept;
  ~Formula();

  /// In the variables' order. May not be a finite number.
  double operator()(std::initializer_list<double> values) const;

  const std::string& text() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The formula of a key; throws InputError located there.
Formula formula_of(const Scene& scene, const std::string& path, const std::string& text,
                   const std::vector<std::string>& variables);

}  // namespace packstone::engine
