#include "core/formats/mapped_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packstone::formats {

MappedFile::MappedFile(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0) {
    const int cause = errno;
    if (file >= 0) close(file);
    throw InputError(path.string() +
                     (cause == ENOENT ? ": no such file" : std::string(": cannot be read: ") + std::strerror(cause)));
  }
  void* memory = nullptr;
  size_ = static_cast<std::size_t>(status.st_size);
  if (S_ISREG(status.st_mode) && size_ > 0) memory = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
  close(file);
  if (!S_ISREG(status.st_mode)) throw InputError(path.string() + ": is not a file");
  if (memory == MAP_FAILED) throw InputError(path.string() + ": cannot be read: " + std::strerror(errno));
  data_ = static_cast<const char*>(memory);
}

MappedFile::~MappedFile() {
  if (data_) munmap(const_cast<char*>(data_), size_);
}

}  // namespace packstone::formats
