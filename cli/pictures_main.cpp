// packstone-pictures: the verbs of packstone that draw. Users call packstone, which hands over to it.

#include "cli/application.hpp"
#include "cli/verbs.hpp"

namespace {

void add_verbs(CLI::App& app) {
  packstone::cli::add_render(app);
  packstone::cli::add_slice(app);
  packstone::cli::add_plot(app);
  packstone::cli::add_report(app);
}

}  // namespace

int main(int argc, char** argv) { return packstone::cli::run_application(argc, argv, add_verbs); }
