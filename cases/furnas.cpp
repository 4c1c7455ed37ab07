#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "cases/program.h"

// The commands of the program, one line each, in the order of the help. `command(verb)` stands for the
// function Command verb_command() of cases/commands/.
// clang-format off
#define FURNAS_COMMANDS(command) \
  command(new)                   \
  command(check)                 \
  command(run)                   \
  command(resume)                \
  command(sweep)                 \
  command(figures)               \
  command(model)                 \
  command(certify)               \
  command(analyze)               \
  command(render)                \
  command(export)                \
  command(replicate)             \
  command(import)                \
  command(info)                  \
  command(bench)                 \
  command(schema)
// clang-format on

namespace furnas {
#define FURNAS_DECLARE(verb) Command verb##_command();
FURNAS_COMMANDS(FURNAS_DECLARE)
#undef FURNAS_DECLARE
}  // namespace furnas

int main(int count, char** values) {
  // It asks a run to save; before there is one, and after it, it must not kill.
  std::signal(SIGUSR1, SIG_IGN);
#define FURNAS_CALL(verb) furnas::verb##_command(),
  const std::vector<furnas::Command> commands = {FURNAS_COMMANDS(FURNAS_CALL)};
#undef FURNAS_CALL
  const std::vector<std::string> arguments(values + 1, values + count);
  return static_cast<int>(furnas::run_program(commands, arguments, {std::cout, std::cerr}));
}
