#include "core/folder_lock.hpp"

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packstone {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  constexpr mode_t mode = 0666;  // less the user's umask
  file_ = open((folder / name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, mode);
  if (file_ < 0) throw InputError(folder.string() + ": cannot be written; name a folder you may write to");
  if (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(std::exchange(file_, -1));
  throw InputError(folder.string() + ": a run is at work in it; stop that one first, or name another folder with -o");
}

FolderLock::~FolderLock() {
  if (file_ >= 0) close(file_);
}

bool FolderLock::is_held(const std::filesystem::path& folder) {
  const int file = open((folder / name).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool held = flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(file);
  return held;
}

}  // namespace packstone
