// The packstone command. Pictures are drawn by a program of their own beside it, so that simulating and measuring do
// not load the renderer's libraries: they take longer to load than a small run, and more memory than 100,000 particles.

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "cli/command_line.hpp"
#include "cli/picture_verbs.hpp"
#include "cli/verbs.hpp"

namespace {

using namespace packstone::cli;

void add_verbs(Program& program) {
  add_run(program);
  add_check(program);
  add_info(program);
  add_analyze(program);
  add_convert(program);
  for (const PictureVerb& verb : picture_verbs) program.add_verb(verb.name, verb.description);  // for --help
}

bool draws(const std::string& verb) {
  return std::any_of(std::begin(picture_verbs), std::end(picture_verbs),
                     [&](const PictureVerb& known) { return verb == known.name; });
}

/// Becomes the program that draws; returns only when that fails.
int hand_over(char** argv) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / pictures_program;
  execv(program.c_str(), argv);
  return refuse(program.string() + " cannot be started: " + std::generic_category().message(errno) +
                "; it draws the pictures and belongs beside packstone (a build without PACKSTONE_VIZ has none)");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && draws(argv[1])) return hand_over(argv);
  return run_program(argc, argv, add_verbs);
}
