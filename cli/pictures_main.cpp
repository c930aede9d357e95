// packstone-pictures: the verbs of packstone that draw. Users call packstone, which hands over to it.

#include <limits>
#include <string>

#include <malloc.h>

#include "cli/command_line.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/verbs.hpp"
#include "core/launched.hpp"

namespace {

void add_verbs(packstone::cli::Program& program) {
  packstone::cli::add_render(program);
  packstone::cli::add_slice(program);
  packstone::cli::add_plot(program);
  packstone::cli::add_report(program);
  packstone::cli::add_tradeoff(program);
  packstone::cli::add_stability(program);
}

/// Pictures take and return megabytes all the time; handed back to the system they would come back as page faults.
void keep_memory() {
  constexpr int largest = 32 << 20;  // that glibc allows
  mallopt(M_MMAP_THRESHOLD, largest);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  for (const packstone::cli::PictureVerb& verb : packstone::cli::picture_verbs) {
    if (argc > 1 && argv[1] == std::string(verb.name) && verb.by_ranks) packstone::join_launch();
  }
  return packstone::cli::run_program(argc, argv, add_verbs);
}
