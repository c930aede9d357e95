// Rows of numbers in text files, as programs write them by the million: blanks between fields, no comments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace packstone::formats {

/// A part of a text file that begins at a line of its own.
struct TextPart {
  std::string_view text;
  std::string source;           ///< the file, before the line's number in messages
  std::int64_t first_line = 1;  ///< number of the first line, counted from 1
};

/// Throws InputError "SOURCE:LINE: what".
[[noreturn]] void fail_at(const std::string& source, std::int64_t line, const std::string& what);

/// Goes through a text line by line.
class LineCursor {
 public:
  explicit LineCursor(TextPart part) : part_(std::move(part)), number_(part_.first_line - 1) {}

  bool at_end() const { return part_.text.empty(); }
  /// The next line without spaces at its ends. Throws InputError when the file ends before; expected says what
  /// should stand there.
  std::string_view next(const std::string& expected);
  /// Passes over so many lines; throws as above when there are fewer.
  void skip(std::size_t lines, const std::string& expected);
  /// The text from here on.
  TextPart rest() const { return {part_.text, part_.source, number_ + 1}; }
  [[noreturn]] void fail(const std::string& what) const { fail_at(part_.source, number_, what); }

 private:
  TextPart part_;
  std::int64_t number_;  ///< of the line read last
};

/// What a field of a row is.
struct RowColumn {
  enum class Kind { skipped, number, word };
  std::string name;  ///< for messages
  Kind kind = Kind::number;
};

/// The columns of rows, in the order of the fields.
struct Rows {
  std::vector<std::vector<double>> values;      ///< (columns)(rows); empty where skipped; of words, the index
  std::vector<std::vector<std::string>> words;  ///< (columns): the words that occur, ascending; empty for numbers
};

/// Reads count rows from the beginning of the text, as many fields each as there are columns.
/// Throws InputError "SOURCE:LINE: column: what; what would be right" where a row has other fields, or one that is
/// not a finite number, and when the text ends before.
Rows read_rows(const TextPart& part, std::size_t count, const std::vector<RowColumn>& columns);

/// "x: "0,5" is not a number; ..." for a field that should be one.
std::string number_complaint(std::string_view name, std::string_view field);

}  // namespace packstone::formats
