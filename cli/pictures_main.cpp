// packstone-pictures: the verbs of packstone that draw. Users call packstone, which hands over to it.

#include "cli/command_line.hpp"
#include "cli/verbs.hpp"

namespace {

void add_verbs(packstone::cli::Program& program) {
  packstone::cli::add_render(program);
  packstone::cli::add_slice(program);
  packstone::cli::add_plot(program);
  packstone::cli::add_report(program);
}

}  // namespace

int main(int argc, char** argv) { return packstone::cli::run_program(argc, argv, add_verbs); }
