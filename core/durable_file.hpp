// Files that outlast a crash of the machine: on the disk before they have their name.
#pragma once

#include <filesystem>
#include <string_view>

namespace packstone {

/// Written under temporary_name(target); gone unless committed.
class DurableFile {
 public:
  /// Throws RunError when the file cannot be made.
  explicit DurableFile(std::filesystem::path target);
  ~DurableFile();
  DurableFile(const DurableFile&) = delete;
  DurableFile& operator=(const DurableFile&) = delete;

  /// Throws RunError when the disk refuses, as all that follow.
  void write(std::string_view bytes);
  /// Has the disk take the bytes, then the name.
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path target_;
  int file_ = -1;
};

/// Has the disk take what was written to a file or, of a folder, what was renamed in it. Throws RunError.
void sync_to_disk(const std::filesystem::path& path);

/// Removes what writers that were killed left in a folder under temporary names.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace packstone
