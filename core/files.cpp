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
  if (error) throw RunError(target.string() + ": cannot be put in place: " + error.message());
}

void write_text_file(const std::filesystem::path& target, const std::string& text) {
  std::ofstream file(temporary_name(target), std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    const std::string cause = std::strerror(errno);
    std::error_code ignored;
    std::filesystem::remove(temporary_name(target), ignored);
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
