// Files that are whole or absent: written under another name, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace packstone {

/// Whether a file that is put in place has to outlast a loss of power: what a run cannot make again within seconds.
enum class Lasting { no, yes };

/// A file being written, under temporary_name(target) until commit. It is locked meanwhile, so that others know it from
/// what a killed process left, which the first PendingFile of a process in a folder removes.
class PendingFile {
 public:
  /// Throws RunError when it cannot be made, or when another process writes the same target.
  explicit PendingFile(std::filesystem::path target);
  /// Without commit nothing stays.
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& target() const { return target_; }
  /// To write to by other means than write().
  std::filesystem::path name() const;
  /// Throws RunError when the disk refuses.
  void write(std::string_view bytes);
  /// Puts the file in place of the target. Throws RunError when the disk refuses.
  void commit(Lasting lasting = Lasting::no);

 private:
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path target_;
  int file_ = -1;
};

/// ".STEM.partial.EXTENSION" in the same folder, so that the rename is atomic. Such files are never results.
std::filesystem::path temporary_name(const std::filesystem::path& target);

/// Removes the temporary files of a folder that nobody writes any more.
void remove_leftovers(const std::filesystem::path& folder);

/// Has the disk take what was written to a file or, of a folder, what was renamed in it. Throws RunError.
void sync_to_disk(const std::filesystem::path& path);

/// Before long work whose file comes at its end. Throws InputError when target is a folder or empty, RunError when no
/// file can be made beside it.
void check_writable(const std::filesystem::path& target);

/// Writes text as a whole file. Throws RunError when the disk refuses.
void write_text_file(const std::filesystem::path& target, const std::string& text, Lasting lasting = Lasting::no);

/// Adds text to the end of a file, all of it or nothing. Throws RunError when the disk refuses.
void append_to_file(const std::filesystem::path& path, std::string_view text);

/// Throws InputError when the file cannot be read.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace packstone
