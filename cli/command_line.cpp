#include "cli/command_line.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/view_file.hpp"
#include "core/error.hpp"
#include "core/flat_toml.hpp"
#include "core/launched.hpp"
#include "core/text.hpp"
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

/// Of several processes that mpirun started the first alone speaks and fails: what started them would otherwise end the
/// first before it has spoken.
int report(ExitCode code, const std::string& message) {
  if (!speaks_for_all()) return static_cast<int>(ExitCode::done);
  const char* kind = code == ExitCode::interrupted ? "interrupted" : "error";
  std::fputs(fmt::format("packstone: {}: {}\n", kind, message).c_str(), stderr);  // also where that cannot be written
  return static_cast<int>(code);
}

const std::string view_option = "view", preset_option = "preset";

bool is_flag(const CLI::Option& option) { return option.get_expected_max() == 0; }

/// Whether a word of the call begins an option.
bool names_option(const std::string& word, const CLI::Option& option) {
  const auto& longs = option.get_lnames();
  const auto& shorts = option.get_snames();
  return std::any_of(
             longs.begin(), longs.end(),
             [&](const std::string& name) { return word == "--" + name || word.starts_with("--" + name + "="); }) ||
         std::any_of(shorts.begin(), shorts.end(),
                     [&](const std::string& name) { return word.starts_with("-" + name); });
}

/// The value that the call gives an option; empty where it does not.
std::string value_in(const std::vector<std::string>& words, const std::string& name) {
  const std::string option = "--" + name;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k].starts_with(option + "=")) return words[k].substr(option.size() + 1);
    if (words[k] == option && k + 1 < words.size()) return words[k + 1];
  }
  return "";
}

/// What the views of a call set; nothing where its verb takes none.
std::vector<ViewSetting> settings_of(const CLI::App& app, const std::vector<std::string>& words) {
  const auto named = [&](const CLI::App* candidate) {
    return !words.empty() && candidate->get_name() == words.front();
  };
  const std::vector<const CLI::App*> verbs = app.get_subcommands(named);
  const CLI::App* verb = verbs.empty() ? nullptr : verbs.front();
  if (!verb || !verb->get_option_no_throw("--" + view_option)) return {};
  const std::string file = value_in(words, view_option), preset = value_in(words, preset_option);
  if (file.empty() && preset.empty()) return {};
  std::vector<ViewOption> options;
  for (const CLI::Option* option : verb->get_options()) {
    if (option->get_lnames().empty()) continue;
    const bool given = std::any_of(words.begin() + 1, words.end(),
                                   [&](const std::string& word) { return names_option(word, *option); });
    options.push_back({option->get_lnames().front(), is_flag(*option), option->get_configurable(), given});
  }
  return view_settings(options, file, preset);
}

/// The line of a view that a message is about; empty where it is about none.
std::string place_of(const std::string& message, const std::vector<ViewSetting>& settings) {
  for (const ViewSetting& setting : settings) {
    const bool named = message.find("--" + setting.name) != std::string::npos;
    const bool quoted = !setting.value.empty() && message.find("'" + setting.value + "'") != std::string::npos;
    if (named || quoted) return setting.place + ": ";
  }
  return "";
}

/// What CLI11 prints for --help and --version is no error.
void parse_or_help(CLI::App& app, std::vector<std::string> words) {
  try {
    app.parse(std::move(words));
  } catch (const CLI::Success& asked) {
    std::ostringstream words_of_help;
    app.exit(asked, words_of_help, words_of_help);
    if (speaks_for_all()) fmt::print("{}", words_of_help.str());
  }
}

/// What was printed may still be on its way, and the disk full.
void flush_standard_output() {
  if (std::fflush(stdout) != 0) throw RunError(std::string("cannot be written: ") + std::strerror(errno));
}

int parse_and_run(CLI::App& app, int argc, char** argv) {
  std::vector<ViewSetting> settings;
  try {
    std::vector<std::string> words(argv + 1, argv + argc);
    settings = settings_of(app, words);
    for (const ViewSetting& setting : settings) {
      words.push_back("--" + setting.name + (setting.flag ? "" : "=" + setting.value));
    }
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    parse_or_help(app, std::move(words));
    flush_standard_output();
  } catch (const CLI::ParseError& error) {
    return report(ExitCode::bad_input, place_of(error.what(), settings) + error.what() + "; see packstone --help");
  } catch (const InputError& error) {
    return report(ExitCode::bad_input, place_of(error.what(), settings) + error.what());
  } catch (const Interrupted& error) {
    return report(ExitCode::interrupted, error.what());
  } catch (const std::bad_alloc&) {
    return report(ExitCode::failed, "not enough memory");
  } catch (const std::exception& error) {
    return report(ExitCode::failed, (std::ferror(stdout) != 0 ? "standard output: " : "") + std::string(error.what()));
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

Option& Option::of_call() {
  option_.configurable(false);
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

void Verb::add_view_options() {
  const auto read_before = [](const std::string&) {};  // parse_and_run has them
  add_word("--" + view_option, read_before, "TOML file of options, named as here, that the call does not give")
      .of_call();
  add_word("--" + preset_option, read_before, "Options for " + joined(preset_names())).of_call();
}

std::string Verb::recipe() const {
  std::string recipe;
  for (const CLI::Option* option : app_.get_options()) {
    if (option->get_lnames().empty() || !option->get_configurable() || option->count() == 0) continue;
    const std::string value = is_flag(*option) ? "true" : toml_quoted(joined(option->results(), ","));
    recipe += fmt::format("{} = {}\n", option->get_lnames().front(), value);
  }
  return recipe;
}

void Verb::set_footer(const std::string& text) { app_.footer(text); }

void Verb::set_action(std::function<void()> action) { app_.callback(std::move(action)); }

Verb Program::add_verb(const std::string& name, const std::string& description) {
  return Verb(*app_.add_subcommand(name, description));
}

int run_program(int argc, char** argv, void (*add_verbs)(Program&)) {
  std::signal(SIGXFSZ,
              SIG_IGN);  // a file above the limit of ulimit -f is an error of its writer, not the end; of ffmpeg's too
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
