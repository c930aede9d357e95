// The two ways a command can fail, as exceptions. Libraries throw; only the command prints and exits.
#pragma once

#include <stdexcept>
#include <string>

namespace packstone {

/// The input or the call is wrong (exit code 2). The message says what is wrong and what would be right.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run or the work failed (exit code 1). The message gives the cause in physical terms.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user interrupted the work (exit code 130); what was done so far is kept.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Exit codes of the command, one meaning each (docs/architecture.md).
enum class ExitCode { done = 0, failed = 1, bad_input = 2, interrupted = 130 };

}  // namespace packstone
