// What the two programs, packstone and packstone-pictures, share: parsing the call, and failures as exit codes.
#pragma once

#include <CLI/CLI.hpp>

namespace packstone::cli {

/// Parses the call and runs its verb, which add_verbs declares; returns the exit code, after one line about a failure.
int run_application(int argc, char** argv, void (*add_verbs)(CLI::App&));

/// Prints "packstone: error: MESSAGE" for bad input and returns its exit code.
int refuse(const std::string& message);

}  // namespace packstone::cli
