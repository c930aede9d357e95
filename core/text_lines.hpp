// Text files with one record a line, as people and other programs write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace packstone {

/// Goes through the lines that say something: blank lines, comments from '#' on, a byte order mark and the line ends of
/// any system are left out. Refers to the text, which must outlive it.
class TextLines {
 public:
  /// source_name stands before the line's number in messages.
  TextLines(std::string_view text, std::string source_name);

  /// Moves to the next line that says something; false at the end.
  bool next();

  /// Without comment and without spaces at its ends.
  std::string_view line() const { return line_; }
  /// What follows '#' in the line, without spaces at its ends; empty without one.
  std::string_view comment() const { return comment_; }
  /// Counted from 1, every line of the file.
  std::int64_t number() const { return number_; }
  const std::string& source_name() const { return source_name_; }

  /// Throws InputError "SOURCE:LINE: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view rest_;
  std::string source_name_;
  std::string_view line_, comment_;
  std::int64_t number_ = 0;
};

/// Without the spaces, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

/// The parts between separators, trimmed; one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The parts between runs of spaces and tabs.
std::vector<std::string_view> words(std::string_view text);

/// The whole text as a number, in C notation whatever the locale; "nan" and "inf" are numbers here.
std::optional<double> parsed_number(std::string_view text);

/// The same for whole numbers; "3.0" and "3e0" are whole too, as table writers put them.
std::optional<std::int64_t> parsed_integer(std::string_view text);

}  // namespace packstone
