// Boundaries about an axis: cylinders, cones, funnels.
#pragma once

#include <array>
#include <vector>

#include "core/boundary_spec.hpp"
#include "core/domain.hpp"
#include "engine/boundary/shape.hpp"

namespace packstone::engine {

/// A cylinder, cone or funnel; a cylinder without length goes through the whole domain.
Shape round_shape(const BoundarySpec& spec, const Domain& domain);

}  // namespace packstone::engine
