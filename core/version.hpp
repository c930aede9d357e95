// Which program this is.
#pragma once

#include <string>

namespace packstone {

/// "0.1.0"
std::string version();
/// Short git revision of the source at configure time, "unknown" outside a checkout.
std::string git_revision();
/// "g++ 12.2.0"
std::string compiler();

}  // namespace packstone
