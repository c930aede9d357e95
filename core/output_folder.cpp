#include "core/output_folder.hpp"

#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace packstone {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  if (path_.empty()) throw InputError("the folder to write into has no name");
  if (fs::exists(path_, error) && !fs::is_directory(path_, error)) {
    throw InputError(path_.string() + ": is a file; name a folder");
  }
  for (fs::path missing = path_; !missing.empty() && !fs::exists(missing, error); missing = missing.parent_path()) {
    made_.push_back(missing);
  }
  fs::create_directories(path_, error);
  if (!error) return;
  remove_if_empty();
  throw RunError(path_.string() + ": cannot be made: " + error.message());
}

OutputFolder::~OutputFolder() { remove_if_empty(); }

void OutputFolder::remove_if_empty() const {
  std::error_code not_empty;
  for (const fs::path& folder : made_) fs::remove(folder, not_empty);
}

}  // namespace packstone
