// Work that may crash, tried in a process of its own first.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace packstone {

/// Libraries that read files may crash, hang or ask for all memory where a file is damaged. Does the work in a copy of
/// this process that may take so much more memory [bytes] and some seconds. Returns what ended it, for a message; empty
/// where it came to its end, by an exception too, or cannot be tried.
std::string failure_in_trial(std::size_t more_memory, const std::function<void()>& work);

}  // namespace packstone
