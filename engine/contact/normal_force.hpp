// What every normal law returns.
#pragma once

namespace packstone::engine {

/// Normal force along the contact normal, in its two parts [N]; positive pushes apart. T: a number, or lanes of them.
template <class T>
struct NormalForce {
  T elastic;
  T damping;

  T total() const { return elastic + damping; }
};

}  // namespace packstone::engine
