// Contact parameters of every pair of materials, by the mixing rules of docs/physics.md.
#pragma once

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
void set_pair(Linear<Release::zero_overlap>::Pair& pair, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(Linear<Release::zero_force>::Pair& pair, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(Hysteretic::Pair& pair, const MaterialSpec& a, const MaterialSpec& b);
void set_pair(CundallStrack::Pair& pair, const MaterialSpec& a, const MaterialSpec& b);
inline void set_pair(Frictionless::Pair&, const MaterialSpec&, const MaterialSpec&) {}

/// Stiffness that limits the time step: the steepest slope of force over overlap of a pair [N/m].
double largest_stiffness(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b);

/// Dashpot coefficient of a pair with this effective mass [kg]; 0 for laws without one [N s/m].
double largest_damping(const Scene& scene, const MaterialSpec& a, const MaterialSpec& b, double effective_mass);

/// Parameters of a law by two material indices.
template <class Law>
class PairTable {
 public:
  explicit PairTable(const std::vector<MaterialSpec>& materials) : count_(materials.size()), pairs_(count_ * count_) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < count_; ++j) set_pair(pairs_[i * count_ + j], materials[i], materials[j]);
    }
  }

  const typename Law::Pair& operator()(std::size_t i, std::size_t j) const { return pairs_[i * count_ + j]; }

 private:
  std::size_t count_;
  std::vector<typename Law::Pair> pairs_;
};

}  // namespace packstone::engine
