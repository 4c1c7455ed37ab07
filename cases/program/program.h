#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"

namespace furnas {

/// Reads the command line (without the program's name), runs the command that it names, and turns every error
/// into one line "furnas: ..." and an exit code.
ExitCode run_program(std::span<const Command> commands, std::vector<std::string> arguments, Console console);

}  // namespace furnas
