#include "core/files.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packstone {

namespace fs = std::filesystem;

namespace {

constexpr const char* partial = ".partial";
constexpr mode_t new_file_mode = 0666;  ///< less the user's umask
/// How long a writer waits for another to be gone: a worker that outlives its killed parent, or who clears leftovers.
constexpr int lock_attempts = 200;
constexpr useconds_t lock_interval = 10000;  ///< [us]

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Some file systems have no locks; there nobody is told from the dead, and nothing is cleared away.
bool has_no_locks(int error) { return error == ENOSYS || error == EOPNOTSUPP || error == ENOLCK || error == EINVAL; }

bool is_still_there(int file, const fs::path& name) {
  struct stat opened {
  }, named{};
  return fstat(file, &opened) == 0 && stat(name.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

/// An open file of this name that this process alone writes; -1 with errno where there is none, EWOULDBLOCK where
/// another process writes it.
int open_locked(const fs::path& name) {
  for (int attempt = 0; attempt < lock_attempts; ++attempt) {
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, new_file_mode);
    if (file < 0) return -1;
    const bool locked = flock(file, LOCK_EX | LOCK_NB) == 0;
    const int error = errno;
    if (locked ? is_still_there(file, name) : has_no_locks(error)) return file;
    close(file);
    errno = EWOULDBLOCK;
    if (!locked) usleep(lock_interval);
  }
  return -1;
}

void remove_leftovers_once(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> done;
  const std::lock_guard guard(mutex);
  std::error_code error;
  if (done.insert(fs::absolute(folder, error)).second) remove_leftovers(folder);
}

}  // namespace

fs::path temporary_name(const fs::path& target) {
  // The extension stays last: some writers choose the format by it.
  return target.parent_path() / ("." + target.stem().string() + partial + target.extension().string());
}

PendingFile::PendingFile(fs::path target) : target_(std::move(target)) {
  remove_leftovers_once(target_.parent_path());
  file_ = open_locked(name());
  if (file_ >= 0 && (ftruncate(file_, 0) == 0 || errno == EINVAL)) return;  // devices have no length
  if (file_ < 0 && errno == EWOULDBLOCK) throw RunError(target_.string() + ": another process is writing it");
  fail("cannot be written");
}

PendingFile::~PendingFile() {
  if (file_ < 0) return;
  std::error_code ignored;
  fs::remove(name(), ignored);
  close(file_);
}

fs::path PendingFile::name() const { return temporary_name(target_); }

void PendingFile::fail(const char* what) const {
  throw RunError(target_.string() + ": " + what + ": " + std::strerror(errno));
}

void PendingFile::write(std::string_view bytes) {
  if (!write_all(file_, bytes)) fail("cannot be written");
}

void PendingFile::commit(Lasting lasting) {
  if (lasting == Lasting::yes) sync_to_disk(name());
  if (close(dup(file_)) != 0) fail("cannot be written");  // over a network a full disk may show only now
  if (rename(name().c_str(), target_.c_str()) != 0) fail("cannot be put in place");
  close(std::exchange(file_, -1));
  if (lasting == Lasting::yes) sync_to_disk(fs::absolute(target_).parent_path());
}

void remove_leftovers(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.') || name.find(partial) == std::string::npos || !entry.is_regular_file(error)) continue;
    const int file = open(entry.path().c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) continue;
    if (flock(file, LOCK_EX | LOCK_NB) == 0 && is_still_there(file, entry.path())) fs::remove(entry.path(), error);
    close(file);
  }
}

void sync_to_disk(const fs::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && fsync(file) == 0;
  const int cause = errno;
  if (file >= 0) close(file);
  // Pipes and devices cannot be synchronised, folders of some file systems neither.
  if (!done && cause != EINVAL) throw RunError(path.string() + ": cannot be written: " + std::strerror(cause));
}

void check_writable(const fs::path& target) {
  std::error_code error;
  if (target.empty()) throw InputError("the file to write has no name");
  if (fs::is_directory(target, error)) throw InputError(target.string() + ": is a folder; name a file");
  const fs::path probe = temporary_name(temporary_name(target));  // not what the file is written under
  if (!std::ofstream(probe, std::ios::binary)) {
    throw RunError(target.string() + ": cannot be written: " + std::strerror(errno));
  }
  fs::remove(probe, error);
}

void write_text_file(const fs::path& target, const std::string& text, Lasting lasting) {
  PendingFile file(target);
  file.write(text);
  file.commit(lasting);
}

void append_to_file(const fs::path& path, std::string_view text) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, new_file_mode);
  struct stat before {};
  bool done = file >= 0 && fstat(file, &before) == 0 && write_all(file, text);
  int cause = errno;
  if (file >= 0 && !done) [[maybe_unused]] const int cut = ftruncate(file, before.st_size);
  if (file >= 0 && close(file) != 0 && done) {
    done = false;
    cause = errno;
  }
  if (!done) throw RunError(path.string() + ": cannot be written: " + std::strerror(cause));
}

std::string read_text_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || fs::is_directory(path)) {
    throw InputError(path.string() + (fs::exists(path) ? ": cannot be read" : ": no such file"));
  }
  return text.str();
}

}  // namespace packstone
