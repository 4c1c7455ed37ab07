#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
class Option;
}  // namespace CLI

namespace furnas {

/// A declared option or argument, to which further conditions can be added. They are checked while the
/// command line is read.
class Argument {
 public:
  explicit Argument(CLI::Option& option) : option_(&option) {}

  Argument required();                                   ///< the command needs it
  Argument showing_default();                            ///< the help shows the present value as the default
  Argument separated_by(char letter);                    ///< a list may be one word
  Argument above_zero();                                 ///< a number above zero
  Argument not_negative();                               ///< a number of zero or more
  Argument between(int least, int most);                 ///< a whole number, ends included
  Argument between(double least, double most);           ///< a number, ends included
  Argument one_of(const std::vector<std::string>& all);  ///< one of these words
  Argument excludes(const Argument& other);              ///< not together with the other
  Argument needs(const Argument& other);                 ///< only together with the other

 private:
  CLI::Option* option_;
};

/// Options and arguments of a command; each is declared once, with the variable that it sets.
///
/// The class hides CLI11 from the commands, because the header of CLI11 takes 7 to 10 seconds to compile.
class CommandLine {
 public:
  explicit CommandLine(CLI::App& app) : app_(&app) {}

  /// An option "--name", or with a name in capitals an argument, for `value`: a string, a path, a number, an
  /// optional number or a vector of strings or numbers.
  template <class T>
  Argument add(const std::string& name, T& value, const std::string& does);

  /// An option without a value.
  Argument flag(const std::string& name, bool& value, const std::string& does);
  Argument flag(const std::string& name, std::function<void()> then, const std::string& does);

  /// A subcommand of this command; one of the subcommands must be given.
  CommandLine subcommand(const std::string& name, const std::string& does);

  /// Whether the command was given, once the command line has been read.
  bool parsed() const;

 private:
  CLI::App* app_;
};

}  // namespace furnas
