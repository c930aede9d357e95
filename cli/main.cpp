// The packstone command: parses the call, maps failures to exit codes.

#include <cstdio>
#include <new>

#include <fmt/format.h>

#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/version.hpp"

namespace {

using packstone::ExitCode;

int report(ExitCode code, const std::string& message) {
  const char* kind = code == ExitCode::interrupted ? "interrupted" : "error";
  fmt::print(stderr, "packstone: {}: {}\n", kind, message);
  return static_cast<int>(code);
}

int run_command(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return report(ExitCode::bad_input, std::string(error.what()) + "; see packstone --help");
  } catch (const packstone::InputError& error) {
    return report(ExitCode::bad_input, error.what());
  } catch (const packstone::Interrupted& error) {
    return report(ExitCode::interrupted, error.what());
  } catch (const std::bad_alloc&) {
    return report(ExitCode::failed, "not enough memory");
  } catch (const std::exception& error) {
    return report(ExitCode::failed, error.what());
  }
  return static_cast<int>(ExitCode::done);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Simulates, measures and draws packings of powders and grains.", "packstone");
  app.set_version_flag("--version", fmt::format("packstone {} (git {}, {})", packstone::version(),
                                                packstone::git_revision(), packstone::compiler()));
  app.require_subcommand(1);
  app.get_formatter()->column_width(32);
  packstone::cli::add_run(app);
  packstone::cli::add_info(app);
  packstone::cli::add_analyze(app);
#ifdef PACKSTONE_WITH_VIZ
  packstone::cli::add_render(app);
  packstone::cli::add_slice(app);
  packstone::cli::add_plot(app);
  packstone::cli::add_report(app);
#endif
  return run_command(app, argc, argv);
}
