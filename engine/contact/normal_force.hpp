// What normal laws are given and what they return.
#pragma once

namespace packstone::engine {

/// Two bodies apart from where they are, at full size; a wall is the limit of infinite mass and radius.
/// T: a number, or lanes of them.
template <class T>
struct PairSize {
  T inverse_mass_sum;  ///< 1/m_i + 1/m_j [1/kg]
  T effective_radius;  ///< R_i R_j / (R_i + R_j) [m]
};

/// Normal force along the contact normal, in its two parts [N]; positive pushes apart.
template <class T>
struct NormalForce {
  T elastic;
  T damping;
  T loss = T(0.0);  ///< by plastic deformation in this step [J]

  T total() const { return elastic + damping; }
};

}  // namespace packstone::engine
