#include "cli/application.hpp"

#include <cstdio>
#include <new>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/version.hpp"

namespace packstone::cli {

namespace {

int report(ExitCode code, const std::string& message) {
  const char* kind = code == ExitCode::interrupted ? "interrupted" : "error";
  fmt::print(stderr, "packstone: {}: {}\n", kind, message);
  return static_cast<int>(code);
}

int parse_and_run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return report(ExitCode::bad_input, std::string(error.what()) + "; see packstone --help");
  } catch (const InputError& error) {
    return report(ExitCode::bad_input, error.what());
  } catch (const Interrupted& error) {
    return report(ExitCode::interrupted, error.what());
  } catch (const std::bad_alloc&) {
    return report(ExitCode::failed, "not enough memory");
  } catch (const std::exception& error) {
    return report(ExitCode::failed, error.what());
  }
  return static_cast<int>(ExitCode::done);
}

}  // namespace

int run_application(int argc, char** argv, void (*add_verbs)(CLI::App&)) {
  CLI::App app("Simulates, measures and draws packings of powders and grains.", "packstone");
  app.set_version_flag("--version", fmt::format("packstone {} (git {}, {})", version(), git_revision(), compiler()));
  app.require_subcommand(1);
  app.get_formatter()->column_width(32);
  add_verbs(app);
  return parse_and_run(app, argc, argv);
}

int refuse(const std::string& message) { return report(ExitCode::bad_input, message); }

}  // namespace packstone::cli
