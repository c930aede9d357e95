#include "core/files.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace packstone {

std::filesystem::path temporary_name(const std::filesystem::path& target) {
  // The extension stays last: some writers choose the format by it.
  return target.parent_path() / ("." + target.stem().string() + ".partial" + target.extension().string());
}

void commit_file(const std::filesystem::path& target) {
  std::error_code error;
  std::filesystem::rename(temporary_name(target), target, error);
  if (!error) return;
  discard_temporary(target);
  throw RunError(target.string() + ": cannot be put in place: " + error.message());
}

void discard_temporary(const std::filesystem::path& target) {
  std::error_code ignored;
  std::filesystem::remove(temporary_name(target), ignored);
}

void check_writable(const std::filesystem::path& target) {
  std::error_code error;
  if (target.empty()) throw InputError("the file to write has no name");
  if (std::filesystem::is_directory(target, error)) throw InputError(target.string() + ": is a folder; name a file");
  const std::filesystem::path probe = temporary_name(temporary_name(target));  // not what the file is written under
  if (!std::ofstream(probe, std::ios::binary)) {
    throw RunError(target.string() + ": cannot be written: " + std::strerror(errno));
  }
  std::filesystem::remove(probe, error);
}

void write_text_file(const std::filesystem::path& target, const std::string& text) {
  std::ofstream file(temporary_name(target), std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    const std::string cause = std::strerror(errno);
    discard_temporary(target);
    throw RunError(target.string() + ": cannot be written: " + cause);
  }
  commit_file(target);
}

std::string read_text_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || std::filesystem::is_directory(path)) {
    throw InputError(path.string() + (std::filesystem::exists(path) ? ": cannot be read" : ": no such file"));
  }
  return text.str();
}

}  // namespace packstone
