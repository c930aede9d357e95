// What every normal law returns.
#pragma once

namespace packstone::engine {

/// Normal force along the contact normal, in its two parts [N]; positive pushes apart.
struct NormalForce {
  double elastic = 0;
  double damping = 0;

  double total() const { return elastic + damping; }
};

}  // namespace packstone::engine
