// How packstone render shows the state in which a run was stopped.
#pragma once

#include "cli/render_call.hpp"

namespace packstone::cli {

/// With --failure, run folders give way to the states in which they were stopped. Where all paths are such states, and
/// unless the call says otherwise, colours mark the offenders and those in contact with them, which keep their size
/// while the others shrink, so that one sees them inside a bed. Throws InputError.
void show_failure(RenderCall& call);

}  // namespace packstone::cli
