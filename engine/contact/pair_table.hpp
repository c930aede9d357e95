// Contact parameters of every pair of materials, by the mixing rules of docs/physics.md.
#pragma once

#include <array>
#include <vector>

#include "core/scene.hpp"
#include "engine/contact/cundall_strack.hpp"
#include "engine/contact/frictionless.hpp"
#include "engine/contact/hysteretic.hpp"
#include "engine/contact/linear.hpp"

namespace packstone::engine {

/// Springs and dashpots act in series, scaled so that equal bodies keep their own value: 2 a b / (a + b); 0 with
/// either.
double in_series(double a, double b);

/// Fills the parameters of a law for two materials in contact. A restitution is mixed as sqrt(e_i e_j) and turned into
/// damping for the pair, so that unequal masses come out right.
void set_pair(Linear<Release::zero_overlap>::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(Linear<Release::zero_force>::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(Hysteretic::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(CundallStrack::Parameters<double>& pair, const MaterialSpec& a, const MaterialSpec& b);
inline void set_pair(Frictionless::Parameters<double>&, const MaterialSpec&, const MaterialSpec&) {}

/// Stiffness that limits the time step: the steepest slope of force over overlap of a pair [N/m].
double largest_stiffness(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b);

/// Dashpot coefficient of a pair with this effective mass [kg]; 0 for laws without one [N s/m].
double largest_damping(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b, double effective_mass);

/// Parameters of a law by two material indices, one table a parameter, so that lanes can gather from it.
template <class Law>
class PairTable {
 public:
  using Numbers = typename Law::template Parameters<double>;

  explicit PairTable(const std::vector<MaterialSpec>& materials) : count_(materials.size()) {
    for (const auto& a : materials) {
      for (const auto& b : materials) {
        Numbers pair{};
        set_pair(pair, a, b);
        const auto values = pair.values();
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
