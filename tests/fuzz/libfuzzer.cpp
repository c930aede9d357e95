// One of the targets under libFuzzer: tests/fuzz/run.sh.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "targets.hpp"

namespace {

const packstone::fuzz::Target* target = nullptr;

}  // namespace

/// PACKSTONE_FUZZ_TARGET names the target; its seeds go into the folder PACKSTONE_FUZZ_SEEDS. Without a name all are
/// listed.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* const name = std::getenv("PACKSTONE_FUZZ_TARGET");
  if (!name) {
    for (const auto& known : packstone::fuzz::targets()) std::puts(known.name);
    std::exit(EXIT_SUCCESS);
  }
  target = &packstone::fuzz::target_named(name);
  if (const char* const folder = std::getenv("PACKSTONE_FUZZ_SEEDS")) {
    int number = 0;
    for (const std::string& seed : target->seeds()) {
      std::ofstream(std::filesystem::path(folder) / ("seed_" + std::to_string(number++)), std::ios::binary) << seed;
    }
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  packstone::fuzz::is_accepted(*target, {reinterpret_cast<const char*>(bytes), count});
  return 0;
}
