// Options of the measures on the command line.
#pragma once

#include <CLI/CLI.hpp>

#include "analysis/options.hpp"

namespace packstone::cli {

/// options must outlive the parsing.
void add_measure_options(CLI::App& verb, analysis::Options& options);

}  // namespace packstone::cli
