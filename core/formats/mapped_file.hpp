// A file's bytes without a copy of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace packstone::formats {

/// A whole file mapped into memory, read only. Only what is looked at is read from the disk.
class MappedFile {
 public:
  /// Throws InputError that names the file when it is not there, not a file, or cannot be read.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view text() const { return {data_, size_}; }

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace packstone::formats
