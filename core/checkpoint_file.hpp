// One file that holds a run's state: named parts, each with a checksum (docs/format.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive.hpp"
#include "core/files.hpp"
#include "core/formats/mapped_file.hpp"

namespace packstone {

/// Where a part lies in the file.
struct CheckpointPart {
  std::string name;
  std::uint64_t offset = 0, size = 0;
  std::uint64_t checksum = 0;
};

/// The file is whole or absent; without commit it is absent.
class CheckpointWriter final : public Archive {
 public:
  /// Throws RunError when the disk refuses, as do all members.
  explicit CheckpointWriter(const std::filesystem::path& target);

  bool reads() const override { return false; }
  void begin(std::string_view part) override;
  void commit();

 private:
  void bytes(void* data, std::size_t size) override;
  std::size_t left() const override { return 0; }
  [[noreturn]] void fail() const override;
  void flush();

  PendingFile file_;
  std::string buffer_;
  std::uint64_t written_ = 0;  ///< bytes, those in the buffer included
  std::vector<CheckpointPart> parts_;
};

class CheckpointReader final : public Archive {
 public:
  /// Checks the whole file first. Throws InputError that names what is wrong with it.
  explicit CheckpointReader(const std::filesystem::path& path);

  bool reads() const override { return true; }
  /// Parts may be read in any order, and again.
  void begin(std::string_view part) override;

 private:
  void bytes(void* data, std::size_t size) override;
  std::size_t left() const override { return rest_.size(); }
  [[noreturn]] void fail() const override;
  [[noreturn]] void damaged(const std::string& what) const;
  void read_table();

  std::filesystem::path path_;
  formats::MappedFile file_;
  std::vector<CheckpointPart> parts_;
  std::string_view rest_;  ///< of the part being read
};

}  // namespace packstone
