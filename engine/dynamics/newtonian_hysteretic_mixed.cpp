#include "engine/dynamics/newtonian_with_definition.hpp"

namespace packstone::engine {

template std::unique_ptr<Dynamics> newtonian_with<Hysteretic, CundallStrack, MixedPrecision<simd::WidestSingle>>(
    const Scene&, const Domain&, const Boundaries&);

}  // namespace packstone::engine
