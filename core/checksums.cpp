#include "core/checksums.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include <isa-l/crc64.h>

namespace packstone {

namespace {

constexpr std::uint64_t mark = 0x316d75736b636170;  ///< "packsum1"
constexpr std::size_t words_a_column = 3;
constexpr std::size_t closing_words = 4;  ///< number of columns, sum of the structure, sum of the words so far, mark

using Words = std::vector<std::uint64_t>;

std::size_t bytes_of(std::size_t words) { return words * sizeof(std::uint64_t); }

/// Bytes behind the file's end.
std::size_t size_behind(std::size_t columns) { return bytes_of(words_a_column * columns + closing_words); }

std::uint64_t structure_sum(std::string_view file, const std::vector<ColumnSum>& columns) {
  std::uint64_t sum = 0;
  std::size_t at = 0;
  const auto add_up_to = [&](std::size_t end) { sum = checksum_of(file.data() + at, end - at, sum); };
  for (const ColumnSum& column : columns) {
    add_up_to(column.first);
    at = column.first + column.bytes;
  }
  add_up_to(file.size());
  return sum;
}

bool stand_apart(const std::vector<ColumnSum>& columns, std::size_t file_size) {
  std::uint64_t end = 0;
  for (const ColumnSum& column : columns) {
    if (column.first < end || column.first > file_size || column.bytes > file_size - column.first) return false;
    end = column.first + column.bytes;
  }
  return true;
}

}  // namespace

std::uint64_t checksum_of(const void* bytes, std::size_t count, std::uint64_t before) {
  return crc64_ecma_refl(before, static_cast<const unsigned char*>(bytes), count);
}

Checksums::Checksums(std::string_view file, std::vector<ColumnSum> columns) : columns_(std::move(columns)) {
  for (ColumnSum& column : columns_) column.sum = checksum_of(file.data() + column.first, column.bytes);
  structure_ = structure_sum(file, columns_);
}

std::optional<Checksums> Checksums::behind(std::string_view file) {
  if constexpr (std::endian::native != std::endian::little) return std::nullopt;
  Words closing(closing_words);
  if (file.size() < bytes_of(closing_words)) return std::nullopt;
  std::memcpy(closing.data(), file.data() + file.size() - bytes_of(closing_words), bytes_of(closing_words));
  const auto [count, structure, own, last] = std::tuple(closing[0], closing[1], closing[2], closing[3]);
  if (last != mark || count > file.size() / bytes_of(words_a_column)) return std::nullopt;
  if (size_behind(count) > file.size()) return std::nullopt;
  const std::string_view words = file.substr(file.size() - size_behind(count));
  if (checksum_of(words.data(), words.size() - bytes_of(2)) != own) return std::nullopt;
  Checksums sums;
  sums.structure_ = structure;
  for (std::size_t k = 0; k < count; ++k) {
    ColumnSum& column = sums.columns_.emplace_back();
    std::memcpy(&column, words.data() + k * bytes_of(words_a_column), bytes_of(words_a_column));
  }
  return stand_apart(sums.columns_, file.size() - size_behind(count)) ? std::optional(sums) : std::nullopt;
}

std::string Checksums::text() const {
  Words words;
  for (const ColumnSum& column : columns_) words.insert(words.end(), {column.first, column.bytes, column.sum});
  words.insert(words.end(), {columns_.size(), structure_});
  words.push_back(checksum_of(words.data(), bytes_of(words.size())));
  words.push_back(mark);
  return {reinterpret_cast<const char*>(words.data()), bytes_of(words.size())};
}

bool Checksums::fit_structure_of(std::string_view file) const {
  file.remove_suffix(size_behind(columns_.size()));
  return structure_sum(file, columns_) == structure_;
}

std::optional<ColumnSum> Checksums::column_at(std::uint64_t first) const {
  const auto found = std::lower_bound(columns_.begin(), columns_.end(), first,
                                      [](const ColumnSum& column, std::uint64_t at) { return column.first < at; });
  return found != columns_.end() && found->first == first ? std::optional(*found) : std::nullopt;
}

}  // namespace packstone
