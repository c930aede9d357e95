// Options of the measures on the command line.
#pragma once

#include "analysis/options.hpp"
#include "cli/command_line.hpp"

namespace packstone::cli {

/// options must outlive the parsing.
void add_measure_options(Verb& verb, analysis::Options& options);

}  // namespace packstone::cli
