#include "cli/command_line.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/version.hpp"

namespace packstone::cli {

namespace {

constexpr std::size_t help_column = 32;  ///< where the descriptions begin

/// What CLI11's ranges let through.
const CLI::Validator& is_number() {
  static const CLI::Validator check(
      [](const std::string& word) {
        double value = 0;
        const bool nan = CLI::detail::lexical_cast(word, value) && std::isnan(value);
        return nan ? std::string("nan is no value") : std::string();
      },
      "");
  return check;
}

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

Option& Option::required() {
  option_.required();
  return *this;
}

Option& Option::heading(const std::string& text) {
  option_.group(text);
  return *this;
}

Option& Option::shows_default() {
  option_.capture_default_str();
  return *this;
}

Option& Option::one_at_a_time() {
  option_.allow_extra_args(false);
  return *this;
}

Option& Option::by_comma() {
  option_.delimiter(',')->allow_extra_args(false);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
  option_.check(CLI::IsMember(words));
  return *this;
}

Option& Option::needs(Option other) {
  option_.needs(&other.option_);
  return *this;
}

Option& Option::not_with(Option other) {
  option_.excludes(&other.option_);
  return *this;
}

Option& Option::positive() {
  option_.check(CLI::PositiveNumber)->check(is_number());
  return *this;
}

Option& Option::not_negative() {
  option_.check(CLI::NonNegativeNumber)->check(is_number());
  return *this;
}

Option& Option::between(int lowest, int highest) {
  option_.check(CLI::Range(lowest, highest));
  return *this;
}

Option& Option::between(double lowest, double highest) {
  option_.check(CLI::Range(lowest, highest))->check(is_number());
  return *this;
}

template <class Value>
Option Verb::add(const std::string& names, Value& value, const std::string& description) {
  return Option(*app_.add_option(names, value, description));
}

template Option Verb::add(const std::string&, std::string&, const std::string&);
template Option Verb::add(const std::string&, std::filesystem::path&, const std::string&);
template Option Verb::add(const std::string&, int&, const std::string&);
template Option Verb::add(const std::string&, double&, const std::string&);
template Option Verb::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option Verb::add(const std::string&, std::vector<std::filesystem::path>&, const std::string&);
template Option Verb::add(const std::string&, std::vector<std::int64_t>&, const std::string&);

Option Verb::add_flag(const std::string& names, bool& value, const std::string& description) {
  return Option(*app_.add_flag(names, value, description));
}

Option Verb::add_word(const std::string& names, std::function<void(const std::string&)> read,
                      const std::string& description) {
  return Option(*app_.add_option_function<std::string>(names, std::move(read), description));
}

Option Verb::add_words(const std::string& names, std::function<void(const std::string&)> read,
                       const std::string& description) {
  const auto read_all = [read = std::move(read)](const std::vector<std::string>& words) {
    for (const std::string& word : words) read(word);
  };
  return Option(
      *app_.add_option_function<std::vector<std::string>>(names, read_all, description)->allow_extra_args(false));
}

void Verb::set_footer(const std::string& text) { app_.footer(text); }

void Verb::set_action(std::function<void()> action) { app_.callback(std::move(action)); }

Verb Program::add_verb(const std::string& name, const std::string& description) {
  return Verb(*app_.add_subcommand(name, description));
}

int run_program(int argc, char** argv, void (*add_verbs)(Program&)) {
  CLI::App app("Simulates, measures and draws packings of powders and grains.", "packstone");
  app.set_version_flag("--version", fmt::format("packstone {} (git {}, {})", version(), git_revision(), compiler()));
  app.require_subcommand(1);
  app.get_formatter()->column_width(help_column);
  Program program(app);
  add_verbs(program);
  return parse_and_run(app, argc, argv);
}

int refuse(const std::string& message) { return report(ExitCode::bad_input, message); }

}  // namespace packstone::cli
