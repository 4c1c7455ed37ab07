#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "cases/program/command_line.h"
#include "cases/program/exit_code.h"

namespace furnas {

/// Where a command prints.
struct Console {
  std::ostream& out;  ///< results
  std::ostream& err;  ///< progress and errors
};

/// One command of the program. `setup` declares its options and stores their values for `run`; `run` throws
/// InputError for any error that the user can correct.
struct Command {
  std::string name;
  std::string does;     ///< one line for the table of commands
  std::string example;  ///< a line that can be typed as it is
  std::function<void(CommandLine& app)> setup;
  std::function<ExitCode(Console console)> run;
};

}  // namespace furnas
