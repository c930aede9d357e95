// Contact parameters of every pair of materials.
#pragma once

#include <array>
#include <vector>

#include "core/scene.hpp"
#include "engine/contact/mixing.hpp"

namespace packstone::engine {

/// Parameters of a law by two material indices, one table a parameter, so that lanes can gather from it.
template <class Law>
class PairTable {
 public:
  using Numbers = typename Law::template Parameters<double>;

  PairTable(const ContactSpec& contact, const std::vector<MaterialSpec>& materials) : count_(materials.size()) {
    for (const auto& a : materials) {
      for (const auto& b : materials) {
        Numbers pair{};
        set_pair(pair, contact, a, b);
        const auto values = numbers_of(pair);
        for (std::size_t k = 0; k < values.size(); ++k) table_[k].push_back(values[k]);
      }
    }
  }

  std::size_t materials() const { return count_; }
  const double* table(int parameter) const { return table_[parameter].data(); }

 private:
  std::size_t count_;
  std::array<std::vector<double>, Numbers::count> table_;
};

}  // namespace packstone::engine
