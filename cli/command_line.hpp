// The program's call: verbs, each with its options. Over CLI11, which only command_line.cpp includes: every file that
// does takes five seconds longer to compile.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace packstone::cli {

/// An option or argument just declared, to be refined.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(option) {}

  Option& required();
  Option& heading(const std::string& text);               ///< it stands under in the help
  Option& shows_default();                                ///< the value it has now, in the help
  Option& one_at_a_time();                                ///< repeated for more values; a comma separates none
  Option& by_comma();                                     ///< several values in one word
  Option& one_of(const std::vector<std::string>& words);  ///< and no other
  Option& needs(Option other);                            ///< is refused without it
  Option& not_with(Option other);                         ///< is refused beside it
  Option& positive();                                     ///< above 0
  Option& not_negative();                                 ///< 0 or above
  Option& between(int lowest, int highest);               ///< both allowed
  Option& between(double lowest, double highest);         ///< both allowed
  Option& of_call();                                      ///< says nothing about how a picture looks

 private:
  CLI::Option& option_;
};

/// What the program is asked to do: the first word of the call.
class Verb {
 public:
  explicit Verb(CLI::App& app) : app_(app) {}

  /// An option, "-o,--output", or an argument, "path", read into value, which must outlive the parsing. Values are
  /// texts, paths and numbers, and vectors of them: those that command_line.cpp lists.
  template <class Value>
  Option add(const std::string& names, Value& value, const std::string& description);
  Option add_flag(const std::string& names, bool& value, const std::string& description);
  /// An option whose word is handed to read.
  Option add_word(const std::string& names, std::function<void(const std::string&)> read,
                  const std::string& description);
  /// The same for an option that may be repeated.
  Option add_words(const std::string& names, std::function<void(const std::string&)> read,
                   const std::string& description);
  /// The options --view FILE and --preset NAME (view_file.hpp), which set the others that are not given.
  void add_view_options();
  /// The options that say how a picture looks and differ from their defaults, by the call or a view: a view file of
  /// them.
  std::string recipe() const;
  /// Text below the options in the help.
  void set_footer(const std::string& text);
  /// What the verb does once the call is read.
  void set_action(std::function<void()> action);

 private:
  CLI::App& app_;
};

/// The program, to which verbs are added.
class Program {
 public:
  explicit Program(CLI::App& app) : app_(app) {}
  Verb add_verb(const std::string& name, const std::string& description);

 private:
  CLI::App& app_;
};

/// Parses the call and runs its verb, which add_verbs declares; returns the exit code, after one line about a failure.
int run_program(int argc, char** argv, void (*add_verbs)(Program&));

/// Prints "packstone: error: MESSAGE" for bad input and returns its exit code.
int refuse(const std::string& message);

}  // namespace packstone::cli
