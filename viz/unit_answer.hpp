// What one process tells another of a unit of work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace packstone::viz {

enum class Outcome : std::uint8_t { done, input_error, failure, interrupted };

/// What a worker says of a unit, with its words where it failed. Plain bytes: it is sent as it is.
struct Answer {
  static constexpr std::size_t longest_words = 2000;

  std::size_t unit = 0;
  std::size_t bytes = 0;  ///< of its result, which follows
  Outcome outcome = Outcome::done;
  char words[longest_words + 1] = {};

  /// Throws what the worker threw: InputError, Interrupted, or RunError for all else. Nothing where all is done.
  void rethrow() const;
};

/// Does the work and tells how it went.
Answer answer_of(std::size_t unit, const std::function<void()>& work);

}  // namespace packstone::viz
