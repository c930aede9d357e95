#include "engine/dynamics/newtonian_with_definition.hpp"

namespace packstone::engine {

template std::unique_ptr<Dynamics>
newtonian_with<Linear<Release::zero_force>, CundallStrack, DoublePrecision<simd::Widest>>(const Scene&, const Domain&,
                                                                                          const Boundaries&);

}  // namespace packstone::engine
