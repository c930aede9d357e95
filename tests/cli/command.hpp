// Runs the built command as a user would.
#pragma once

#include <string>

#include "tests/shell.hpp"

namespace packstone::testing {

/// arguments as a shell would take them; environment goes before the command.
inline Result packstone_command(const std::string& arguments, const std::string& environment = "") {
  return shell(environment + " " + PACKSTONE_COMMAND + " " + arguments);
}

}  // namespace packstone::testing
