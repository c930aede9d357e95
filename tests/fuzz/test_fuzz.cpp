// Every reader on good inputs, on those that were once found to be too much for it, and on some thousand wrong ones.
// Searching for more is libFuzzer's: tests/fuzz/run.sh.
#include <filesystem>

#include <catch2/catch.hpp>

#include "core/files.hpp"
#include "mutations.hpp"
#include "targets.hpp"

using namespace packstone;
using namespace packstone::fuzz;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t mutations_a_target = 2000;
constexpr std::uint64_t mutations_of_forks = 150;  ///< of targets that read each input in a process of its own

bool forks(const std::string& name) {
  return name == "snapshot" || name == "vtk" || name == "vtk_mesh" || name == "stl" || name == "obj" || name == "ply";
}

}  // namespace

TEST_CASE("every reader takes its seeds") {
  for (const Target& target : targets()) {
    for (const std::string& seed : target.seeds()) {
      INFO(target.name << "\n" << seed.substr(0, 200));
      CHECK(is_accepted(target, seed));
    }
  }
}

TEST_CASE("what was once too much for a reader is refused or read") {
  const fs::path folder = fs::path(PACKSTONE_SOURCE_DIR) / "tests/fuzz/regressions";
  for (const Target& target : targets()) {
    if (!fs::exists(folder / target.name)) continue;
    for (const auto& file : fs::directory_iterator(folder / target.name)) {
      INFO(file.path());
      CHECK_NOTHROW(is_accepted(target, read_text_file(file.path())));
    }
  }
}

TEST_CASE("readers survive wrong inputs") {
  for (const Target& target : targets()) {
    const std::vector<std::string> seeds = target.seeds();
    const std::uint64_t mutations = forks(target.name) ? mutations_of_forks : mutations_a_target;
    std::uint64_t refused = 0;
    for (std::uint64_t number = 0; number < mutations; ++number) {
      const std::string& seed = seeds[number % seeds.size()];
      INFO(target.name << ", mutation " << number);
      bool accepted = true;
      REQUIRE_NOTHROW(accepted = is_accepted(target, mutated(seed, number)));
      refused += accepted ? 0 : 1;
    }
    INFO(target.name);
    CHECK(refused > 0);  // or the mutations do nothing
  }
}
