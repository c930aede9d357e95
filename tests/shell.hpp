// Runs other programs as a user would.
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include <sys/wait.h>

namespace packstone::testing {

struct Result {
  int exit_code = -1;
  std::string output;  ///< standard output and standard error together
};

/// A path as one word of a shell's line.
inline std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// What a shell makes of the line.
inline Result shell(const std::string& line) {
  FILE* pipe = popen((line + " 2>&1").c_str(), "r");
  Result result;
  std::array<char, 4096> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe)) result.output += buffer.data();
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace packstone::testing
