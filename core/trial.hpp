// Work that may crash, tried in a process of its own first.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace packstone {

/// What came of it.
struct Trial {
  std::string failure;  ///< what ended it, for a message; empty where it came to its end, by an exception too
  std::string result;   ///< what the work returned
};

/// Libraries that read files may crash, hang or ask for all memory where a file is damaged. Does the work in a copy of
/// this process that may take so much more memory [bytes] and some seconds.
Trial tried(std::size_t more_memory, const std::function<std::string()>& work);

/// The failure alone, of work whose result this process makes once more.
std::string failure_in_trial(std::size_t more_memory, const std::function<void()>& work);

}  // namespace packstone
