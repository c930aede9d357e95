// In which keys two scenes differ.
#pragma once

#include <string>
#include <vector>

namespace packstone {

/// Keys, such as "material[0].friction", whose values differ between two scenes as to_toml writes them, or that one of
/// them has alone. Throws InputError where a text is no TOML.
std::vector<std::string> differing_keys(const std::string& one, const std::string& other);

}  // namespace packstone
