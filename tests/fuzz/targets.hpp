// What is fuzzed: every reader, under a name, with inputs to begin from. libfuzzer.cpp and test_fuzz.cpp run them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace packstone::fuzz {

/// A reader. Inputs that it refuses with InputError are refused; anything else it throws is a fault.
struct Target {
  const char* name;
  void (*read)(const std::string& input);
  std::vector<std::string> (*seeds)();  ///< good inputs
};

const std::vector<Target>& targets();

/// Throws std::invalid_argument that lists the names there are.
const Target& target_named(std::string_view name);

/// Lets the target read; false where it refuses the input.
bool is_accepted(const Target& target, const std::string& input);

}  // namespace packstone::fuzz
