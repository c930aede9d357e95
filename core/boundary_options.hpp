// The keys of [[boundary]], and which go with which kind.
#pragma once

#include <string>

#include "core/options.hpp"
#include "core/scene.hpp"

namespace packstone {

/// As the scene writes it: "plane".
const std::string& kind_name(BoundaryKind kind);

void describe_boundary(OptionVisitor& visitor, BoundarySpec& boundary);

/// Replaces what is left to the program to choose.
void fill_defaults(BoundarySpec& boundary);

/// What can be known of boundaries without building them. Throws InputError located in the scene.
void check_boundaries(const Scene& scene);

}  // namespace packstone
