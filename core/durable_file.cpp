#include "core/durable_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/files.hpp"

namespace packstone {

namespace fs = std::filesystem;

DurableFile::DurableFile(fs::path target) : target_(std::move(target)) {
  constexpr mode_t mode = 0666;  // less the user's umask
  file_ = open(temporary_name(target_).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode);
  if (file_ < 0) fail();
}

DurableFile::~DurableFile() {
  if (file_ < 0) return;
  close(file_);
  discard_temporary(target_);
}

void DurableFile::fail() const { throw RunError(target_.string() + ": cannot be written: " + std::strerror(errno)); }

void DurableFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void DurableFile::commit() {
  if (fsync(file_) != 0) fail();
  if (close(std::exchange(file_, -1)) != 0) {
    const int cause = errno;
    discard_temporary(target_);
    errno = cause;
    fail();
  }
  commit_file(target_);
  sync_to_disk(target_.parent_path());
}

void sync_to_disk(const fs::path& path) {
  const int file = open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && fsync(file) == 0;
  const int cause = errno;
  if (file >= 0) close(file);
  if (!done && cause != EINVAL) {  // folders of some file systems cannot be synchronised
    throw RunError(path.string() + ": cannot be written: " + std::strerror(cause));
  }
}

void remove_leftovers(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') && name.find(".partial") != std::string::npos) fs::remove(entry.path(), error);
  }
}

}  // namespace packstone
