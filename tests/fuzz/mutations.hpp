// Inputs a little wrong, the same for the same number.
#pragma once

#include <cstdint>
#include <string>

namespace packstone::fuzz {

/// One to a few changes: bits, bytes, numbers, parts cut out, doubled or moved, an end cut off.
std::string mutated(const std::string& input, std::uint64_t number);

}  // namespace packstone::fuzz
