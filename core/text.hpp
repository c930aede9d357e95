// Small text helpers for messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace packstone {

/// The candidate with the smallest edit distance to the word, if it is near enough to be meant.
std::optional<std::string> nearest_name(const std::string& word, const std::vector<std::string>& candidates);

/// "a, b, c"
std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ");

/// A text as one word of a shell's line.
std::string shell_word(const std::string& text);

}  // namespace packstone
