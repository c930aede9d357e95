#include "core/formats/number_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

constexpr std::size_t least_row_bytes = 2;  ///< a digit and the line's end
constexpr std::size_t most_words = 10000;   ///< different ones in a column: kinds of particles, not names of each

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Reads the fields of one row after the other.
class RowReader {
 public:
  RowReader(const TextPart& part, const std::vector<RowColumn>& columns)
      : part_(part), columns_(columns), at_(part.text.data()), end_(at_ + part.text.size()), line_(part.first_line) {
    result_.values.resize(columns.size());
    result_.words.resize(columns.size());
    dictionaries_.resize(columns.size());
  }

  Rows read(std::size_t count) {
    if (count > (part_.text.size() + 1) / least_row_bytes) {
      fail_at(part_.source, part_.first_line,
              fmt::format("the file ends before the {} rows it counts; is it cut short?", count));
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (columns_[k].kind != RowColumn::Kind::skipped) result_.values[k].reserve(count);
    }
    for (std::size_t row = 0; row < count; ++row, ++line_) {
      if (at_ == end_) {
        fail_at(part_.source, line_, fmt::format("the file ends after {} of {} rows; is it cut short?", row, count));
      }
      read_row();
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) sort_words(k);
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail_at(part_.source, line_, what); }

  std::string_view field_from(const char* first) const {
    const char* last = first;
    while (last != end_ && !is_blank(*last) && *last != '\n') ++last;
    return {first, static_cast<std::size_t>(last - first)};
  }

  void read_row() {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      while (at_ != end_ && is_blank(*at_)) ++at_;
      if (at_ == end_ || *at_ == '\n') fail_count(k);
      read_field(k);
    }
    while (at_ != end_ && is_blank(*at_)) ++at_;
    if (at_ == end_) return;
    if (*at_ != '\n') {
      std::size_t more = columns_.size();
      while (at_ != end_ && *at_ != '\n') {
        ++more;
        at_ += field_from(at_).size();
        while (at_ != end_ && is_blank(*at_)) ++at_;
      }
      fail_count(more);
    }
    ++at_;
  }

  [[noreturn]] void fail_count(std::size_t found) const {
    std::string names;
    for (const auto& column : columns_) names += " " + column.name;
    fail(fmt::format("the row has {} fields, the header {}:{}; they must agree", found, columns_.size(), names));
  }

  void read_field(std::size_t k) {
    if (columns_[k].kind != RowColumn::Kind::number) {
      const std::string_view field = field_from(at_);
      at_ += field.size();
      if (columns_[k].kind == RowColumn::Kind::word) result_.values[k].push_back(word_index(k, field));
      return;
    }
    double value = 0;
    const char* first = at_ + (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-' ? 1 : 0);
    const auto [last, error] = std::from_chars(first, end_, value);
    const bool whole = last == end_ || is_blank(*last) || *last == '\n';
    if (error != std::errc() || !whole || !std::isfinite(value))
      fail(number_complaint(columns_[k].name, field_from(at_)));
    result_.values[k].push_back(value);
    at_ = last;
  }

  double word_index(std::size_t k, std::string_view word) {
    auto& dictionary = dictionaries_[k];
    const auto found = dictionary.find(word);
    if (found != dictionary.end()) return found->second;
    if (dictionary.size() == most_words) {
      fail(fmt::format("{}: more than {} different words; kinds of particles are expected", columns_[k].name,
                       most_words));
    }
    return dictionary.emplace(std::string(word), static_cast<double>(dictionary.size())).first->second;
  }

  /// Numbers the words by their order in the alphabet: the same in every frame that has the same ones.
  void sort_words(std::size_t k) {
    std::vector<double> place(dictionaries_[k].size());
    for (const auto& [word, first_seen] : dictionaries_[k]) {
      place[static_cast<std::size_t>(first_seen)] = static_cast<double>(result_.words[k].size());
      result_.words[k].push_back(word);
    }
    if (place.empty()) return;
    for (double& value : result_.values[k]) value = place[static_cast<std::size_t>(value)];
  }

  const TextPart& part_;
  const std::vector<RowColumn>& columns_;
  const char* at_;
  const char* end_;
  std::int64_t line_;
  Rows result_;
  std::vector<std::map<std::string, double, std::less<>>> dictionaries_;
};

}  // namespace

void fail_at(const std::string& source, std::int64_t line, const std::string& what) {
  throw InputError(fmt::format("{}:{}: {}", source, line, what));
}

std::string number_complaint(std::string_view name, std::string_view field) {
  const auto value = parsed_number(field);
  if (value && !std::isfinite(*value)) return fmt::format("{}: \"{}\" is not finite", name, field);
  return fmt::format("{}: \"{}\" is not a number; expected one such as 0.02 or 2e-2{}", name, field,
                     field.find(',') == std::string_view::npos ? "" : ", with a point instead of the comma");
}

std::string_view LineCursor::next(const std::string& expected) {
  ++number_;
  if (part_.text.empty()) fail("the file ends here; expected " + expected);
  const std::size_t end = std::min(part_.text.find('\n'), part_.text.size());
  const std::string_view line = part_.text.substr(0, end);
  part_.text.remove_prefix(std::min(end + 1, part_.text.size()));
  return trimmed(line);
}

void LineCursor::skip(std::size_t lines, const std::string& expected) {
  const char* at = part_.text.data();
  const char* const end = at + part_.text.size();
  for (std::size_t k = 0; k < lines; ++k) {
    if (at == end) {
      number_ += static_cast<std::int64_t>(k);
      fail(fmt::format("the file ends after {} of {} {}; is it cut short?", k, lines, expected));
    }
    const auto* found = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
    at = found ? found + 1 : end;
  }
  number_ += static_cast<std::int64_t>(lines);
  part_.text.remove_prefix(static_cast<std::size_t>(at - part_.text.data()));
}

Rows read_rows(const TextPart& part, std::size_t count, const std::vector<RowColumn>& columns) {
  return RowReader(part, columns).read(count);
}

}  // namespace packstone::formats
