#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "cases/program/program.h"

// The commands of the program, one line each, in the order of the help. `command(verb)` stands for the
// function Command verb_command() of cases/program/commands/.
// clang-format off
#define FURNAS_COMMANDS(command) \
  command(new)                   \
  command(check)                 \
  command(run)                   \
  command(resume)                \
  command(sweep)                 \
  command(plot)                  \
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

/// Called when a library gets no memory in a function that must not throw, such as a destructor.
[[noreturn]] void ended_by_a_library() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    constexpr std::string_view sentence =
        "furnas: out of memory, in the middle of a file; resume continues from the last checkpoint\n";
    (void)!::write(STDERR_FILENO, sentence.data(), sentence.size());
    ::_exit(static_cast<int>(furnas::ExitCode::out_of_memory));
  } catch (...) {
  }
  std::abort();
}

/// Makes malloc return freed arrays of a megabyte or more to the system. By default malloc keeps freed arrays
/// of up to 32 MB, so that a run needs about a quarter more memory, by an amount that cannot be predicted.
void give_back_what_is_freed() {
  constexpr int large = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, large);
  ::mallopt(M_TRIM_THRESHOLD, large);
}

int main(int count, char** values) {
  give_back_what_is_freed();
  std::set_terminate(ended_by_a_library);
  // SIGUSR1 requests a checkpoint of a run. Before a run begins and after it has ended, the signal must not
  // end the program.
  std::signal(SIGUSR1, SIG_IGN);
#define FURNAS_CALL(verb) furnas::verb##_command(),
  const std::vector<furnas::Command> commands = {FURNAS_COMMANDS(FURNAS_CALL)};
#undef FURNAS_CALL
  const std::vector<std::string> arguments(values + 1, values + count);
  return static_cast<int>(furnas::run_program(commands, arguments, {std::cout, std::cerr}));
}
