#include "viz/unit_answer.hpp"

#include <cstring>
#include <exception>
#include <new>

#include "core/error.hpp"

namespace packstone::viz {

void Answer::rethrow() const {
  switch (outcome) {
    case Outcome::done:
      return;
    case Outcome::input_error:
      throw InputError(words);
    case Outcome::failure:
      throw RunError(words);
    case Outcome::interrupted:
      throw Interrupted(words);
  }
}

Answer answer_of(std::size_t unit, const std::function<void()>& work) {
  Answer answer{.unit = unit};
  const auto failed = [&](Outcome outcome, const char* words) {
    answer.outcome = outcome;
    std::strncpy(answer.words, words, Answer::longest_words);
  };
  try {
    work();
  } catch (const InputError& error) {
    failed(Outcome::input_error, error.what());
  } catch (const Interrupted& error) {
    failed(Outcome::interrupted, error.what());
  } catch (const std::bad_alloc&) {
    failed(Outcome::failure, "not enough memory");
  } catch (const std::exception& error) {
    failed(Outcome::failure, error.what());
  }
  return answer;
}

}  // namespace packstone::viz
