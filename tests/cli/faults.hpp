// What every verb owes to who calls it where the disk, the rights or the input are not what they should be.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "command.hpp"
#include "core/files.hpp"
#include "tests/temporary_folder.hpp"

namespace packstone::testing {

/// All that is in a folder: of a file its bytes, of a folder none.
inline std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    all[std::filesystem::relative(entry.path(), folder).string()] =
        entry.is_directory() ? "" : read_text_file(entry.path());
  }
  return all;
}

inline void check_one_line(const Result& result) {
  CHECK((result.exit_code == 1 || result.exit_code == 2));
  CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
  CHECK_THAT(result.output, Catch::Matchers::StartsWith("packstone: error: "));
}

/// The call fails with one line that has the words, and leaves the folder as it is.
inline void check_refusal(const std::string& call, const std::string& words, const std::filesystem::path& folder,
                          const std::string& environment = "") {
  const auto before = contents(folder);
  const auto result = packstone_command(call, environment);
  INFO(call << "\n" << result.output);
  check_one_line(result);
  CHECK_THAT(result.output, Catch::Matchers::Contains(words));
  CHECK((contents(folder) == before));
}

/// A file system of a few pages on the folder "disk", and what is in it afterwards in "left".
class SmallDisk {
 public:
  SmallDisk() {
    std::filesystem::create_directory(folder_ / "disk");
    std::filesystem::create_directory(folder_ / "old");
  }

  /// Whether this user may mount one in a namespace of its own.
  bool can_be_made() const { return in_namespace("true", "size=4k").exit_code == 0; }
  std::filesystem::path disk() const { return folder_ / "disk"; }
  std::filesystem::path old() const { return folder_ / "old"; }  ///< what is on the disk before
  std::filesystem::path left() const { return folder_ / "left"; }

  /// Before the call the script "prepare" is run.
  Result run(const std::string& call, const std::string& mount_options, const std::string& prepare = "true") {
    std::filesystem::remove_all(left());
    std::filesystem::create_directory(left());
    const auto q = [](const std::filesystem::path& path) { return quoted(path); };
    return in_namespace("cp -r " + q(old()) + "/. " + q(disk()) + " && " + prepare + "\n" + PACKSTONE_COMMAND + " " +
                            call + "\ncode=$?\ncp -r " + q(disk()) + "/. " + q(left()) + "\nexit $code",
                        mount_options);
  }

 private:
  Result in_namespace(const std::string& script, const std::string& mount_options) const {
    std::ofstream(folder_ / "script.sh") << "mount -t tmpfs -o " << mount_options << " none " << quoted(disk())
                                         << " || exit\n"
                                         << script << "\n";
    return shell("unshare -rm sh " + quoted(folder_ / "script.sh"));
  }

  TemporaryFolder folder_;
};

}  // namespace packstone::testing
