// The layering of docs/architecture.md: each folder includes only what lies below it.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include <catch2/catch.hpp>

namespace fs = std::filesystem;

TEST_CASE("folders include only the layers below them") {
  const std::map<std::string, std::set<std::string>> allowed = {
      {"core", {"core"}}, {"engine", {"core", "engine"}}, {"analysis", {"core", "analysis"}}, {"viz", {"core", "viz"}}};
  const std::regex include(R"(^\s*#include\s+"([a-z]+)/)");
  int files = 0;
  for (const auto& [folder, layers] : allowed) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PACKSTONE_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      ++files;
      std::ifstream source(entry.path());
      for (std::string line; std::getline(source, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        INFO(entry.path().string() << ": " << line);
        CHECK(layers.count(match[1]) == 1);
      }
    }
  }
  CHECK(files > 40);
}
