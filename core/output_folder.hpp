// A folder for files to come, which does not stay where none comes.
#pragma once

#include <filesystem>
#include <vector>

namespace packstone {

class OutputFolder {
 public:
  /// Makes the folder where it is missing, its parents too. Throws InputError when path is a file or empty, RunError
  /// when the disk refuses; nothing made stays then.
  explicit OutputFolder(std::filesystem::path path);
  /// Removes what was made, where it is empty.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void remove_if_empty() const;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

}  // namespace packstone
