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
  std::ostream& err;  ///< progress and complaints
};

/// One command of the program. `setup` declares its options and keeps their values where `run` finds them;
/// `run` throws InputError for anything the user can put right.
struct Command {
  std::string name;
  std::string does;     ///< one line for the table of commands
  std::string example;  ///< a line that can be typed as it is
  std::function<void(CommandLine& app)> setup;
  std::function<ExitCode(Console console)> run;
};

}  // namespace furnas
