#include "core/checkpoint_file.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "core/checksums.hpp"

namespace packstone {

namespace {

constexpr std::string_view first_bytes = "PACKSTCK", last_bytes = "KCTSKCAP";
constexpr std::uint64_t format_version = 1;
constexpr std::size_t buffer_size = std::size_t{1} << 20;

/// What the file begins and ends with; between them the parts, then their table.
struct Head {
  char mark[8];
  std::uint64_t version;
};
struct Tail {
  std::uint64_t table_offset, table_size, table_checksum, file_size;
  char mark[8];
};

template <class T>
std::string_view memory_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

bool is_mark(const char (&mark)[8], std::string_view expected) {
  return std::string_view(mark, sizeof mark) == expected;
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::filesystem::path& target) : file_(target) {
  Head head{{}, format_version};
  std::copy(first_bytes.begin(), first_bytes.end(), head.mark);
  buffer_.reserve(buffer_size);
  buffer_ += memory_of(head);
  written_ = sizeof head;
}

void CheckpointWriter::begin(std::string_view part) { parts_.push_back({std::string(part), written_, 0, 0}); }

void CheckpointWriter::bytes(void* data, std::size_t size) {
  CheckpointPart& part = parts_.back();
  part.checksum = checksum_of(data, size, part.checksum);
  part.size += size;
  written_ += size;
  if (buffer_.size() + size > buffer_size) flush();
  if (size > buffer_size) {
    file_.write({static_cast<const char*>(data), size});
  } else {
    buffer_.append(static_cast<const char*>(data), size);
  }
}

void CheckpointWriter::flush() {
  file_.write(buffer_);
  buffer_.clear();
}

void CheckpointWriter::commit() {
  std::string table;
  for (const CheckpointPart& part : parts_) {
    const std::uint64_t length = part.name.size();
    for (const std::uint64_t number : {part.offset, part.size, part.checksum, length}) table += memory_of(number);
    table += part.name;
  }
  Tail tail{
      written_, table.size(), checksum_of(table.data(), table.size()), written_ + table.size() + sizeof(Tail), {}};
  std::copy(last_bytes.begin(), last_bytes.end(), tail.mark);
  flush();
  file_.write(table);
  file_.write(memory_of(tail));
  file_.commit(Lasting::yes);
}

void CheckpointWriter::fail() const { throw RunError("a checkpoint is written, not read"); }

CheckpointReader::CheckpointReader(const std::filesystem::path& path) : path_(path), file_(path) {
  read_table();
  for (const CheckpointPart& part : parts_) {
    if (checksum_of(file_.text().data() + part.offset, part.size) != part.checksum) {
      damaged(fmt::format("the checksum of its part \"{}\" does not fit", part.name));
    }
  }
}

void CheckpointReader::read_table() {
  const std::string_view text = file_.text();
  Head head;
  Tail tail;
  if (text.size() < sizeof head + sizeof tail) damaged("it is cut short");
  std::memcpy(&head, text.data(), sizeof head);
  if (!is_mark(head.mark, first_bytes)) damaged("it does not begin as a checkpoint does");
  if (head.version != format_version) {
    throw InputError(fmt::format("{}: a checkpoint of format version {}; this program reads version {}", path_.string(),
                                 head.version, format_version));
  }
  std::memcpy(&tail, text.data() + text.size() - sizeof tail, sizeof tail);
  const std::size_t most = text.size() - sizeof tail;
  if (!is_mark(tail.mark, last_bytes) || tail.file_size != text.size() || tail.table_offset > most ||
      tail.table_size != most - tail.table_offset) {
    damaged("it is cut short");
  }
  std::string_view table = text.substr(tail.table_offset, tail.table_size);
  if (checksum_of(table.data(), table.size()) != tail.table_checksum) damaged("the checksum of its table does not fit");
  for (std::uint64_t end = sizeof head; !table.empty();) {
    CheckpointPart part;
    std::uint64_t numbers[4];
    if (table.size() < sizeof numbers) damaged("its table is not one");
    std::memcpy(numbers, table.data(), sizeof numbers);
    table.remove_prefix(sizeof numbers);
    part.offset = numbers[0];
    part.size = numbers[1];
    part.checksum = numbers[2];
    if (part.offset != end || part.size > tail.table_offset - end || numbers[3] > table.size()) {
      damaged("its table is not one");
    }
    end += part.size;
    part.name = table.substr(0, numbers[3]);
    table.remove_prefix(numbers[3]);
    parts_.push_back(std::move(part));
  }
}

void CheckpointReader::begin(std::string_view name) {
  if (!rest_.empty()) fail();
  const auto found = std::find_if(parts_.begin(), parts_.end(), [&](const auto& part) { return part.name == name; });
  if (found == parts_.end()) damaged(fmt::format("it has no part \"{}\"", name));
  rest_ = file_.text().substr(found->offset, found->size);
}

void CheckpointReader::bytes(void* data, std::size_t size) {
  if (size > rest_.size()) fail();
  if (size > 0) std::memcpy(data, rest_.data(), size);
  rest_.remove_prefix(size);
}

void CheckpointReader::fail() const { damaged("it holds another state than this run has"); }

void CheckpointReader::damaged(const std::string& what) const {
  throw InputError(path_.string() + ": no whole checkpoint: " + what);
}

}  // namespace packstone
