// Whether a run is at work in a folder.
#pragma once

#include <filesystem>
#include <utility>

namespace packstone {

/// Held by the process that runs into a folder, and gone with it, however it ends.
class FolderLock {
 public:
  FolderLock() = default;
  /// Throws InputError where another holds it. Where the file system has no locks, nobody is kept out.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  /// Whether a process holds it.
  static bool is_held(const std::filesystem::path& folder);
  /// Name of the file in the folder.
  static constexpr const char* name = ".lock";

 private:
  int file_ = -1;
};

}  // namespace packstone
