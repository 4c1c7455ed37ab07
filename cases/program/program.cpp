#include "cases/program/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <ostream>
#include <system_error>

#include "cases/program/build_info.h"
#include "cases/program/run/folder_lock.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

/// Messages of a library may have several lines; the user gets one line.
std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

ExitCode complain(Console console, ExitCode code, const std::string& what) {
  console.err << "furnas: " << one_line(what) << '\n';
  return code;
}

/// Requests for help and version end with the code 0; a wrong option or argument is an error of the user.
ExitCode answer(const CLI::App& app, const CLI::ParseError& error, Console console) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(error, console.out, console.err);
    return ExitCode::done;
  }
  std::string asked = "furnas";
  for (auto commands = app.get_subcommands(); !commands.empty();
       commands = commands.front()->get_subcommands())
    asked += " " + commands.front()->get_name();
  return complain(console, ExitCode::bad_case,
                  fmt::format("{}; see {} --help", one_line(error.what()), asked));
}

/// Names an unknown command; CLI11 would only report that a command is missing.
std::optional<std::string> unknown_command(std::span<const Command> commands,
                                           const std::vector<std::string>& arguments) {
  std::string known;
  for (const Command& command : commands) {
    if (!arguments.empty() && command.name == arguments.front()) return {};
    known += (known.empty() ? "" : ", ") + command.name;
  }
  if (arguments.empty()) return fmt::format("a command is missing; allowed: {}; see furnas --help", known);
  if (arguments.front().starts_with('-')) return {};
  return fmt::format("{} is no command; allowed: {}; see furnas --help", arguments.front(), known);
}

/// The meaning of the exit codes, for the help text.
constexpr const char* exit_codes =
    "Exit codes:\n"
    "  0    done; of run and resume: jammed or settled\n"
    "  1    an error of the program\n"
    "  2    the case, an option or a path cannot be used\n"
    "  3    refused, because the case would fail\n"
    "  4    a part of the certificate failed\n"
    "  5    steps or wall time are spent; resume continues (sweep: of some samples)\n"
    "  6    the packing diverged; the last sound state is saved\n"
    "  7    a file cannot be written; the last checkpoint is good\n"
    "  8    another run works in the folder\n"
    "  9    out of memory; the last checkpoint is good\n"
    "  10   of a sweep: some or all samples failed or diverged\n"
    "  11   of a sweep: the wall time is spent, and samples are left\n"
    "  130  stopped by a signal, and saved; resume continues\n";

/// Checks that all output was written; the disk may be full.
ExitCode printed(ExitCode code, Console console) {
  if (console.out.flush() || code != ExitCode::done) return code;
  return complain(console, ExitCode::output_failed, "cannot write to the standard output");
}

ExitCode run_guarded(const Command& command, Console console) {
  try {
    return printed(command.run(console), console);
  } catch (const InputError& error) {
    return complain(console, ExitCode::bad_case, error.what());
  } catch (const NumericalFailure& error) {
    return complain(console, ExitCode::numerical_failure, error.what());
  } catch (const OutputError& error) {
    return complain(console, ExitCode::output_failed, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    if (error.code() == std::errc::not_enough_memory)
      return complain(console, ExitCode::out_of_memory, "out of memory");
    const bool bad_path = error.code() == std::errc::permission_denied ||
                          error.code() == std::errc::filename_too_long ||
                          error.code() == std::errc::too_many_symbolic_link_levels;
    return complain(console, bad_path ? ExitCode::bad_case : ExitCode::output_failed, error.what());
  } catch (const std::system_error& error) {
    // The system reports with this error that it has no memory or no number left for another thread.
    if (error.code() == std::errc::resource_unavailable_try_again)
      return complain(console, ExitCode::out_of_memory, "out of memory, or of threads");
    return complain(console, ExitCode::internal_error, fmt::format("internal error: {}", error.what()));
  } catch (const FolderInUse& error) {
    return complain(console, ExitCode::folder_in_use, error.what());
  } catch (const std::bad_alloc&) {
    return complain(console, ExitCode::out_of_memory, "out of memory");
  } catch (const std::exception& error) {
    return complain(console, ExitCode::internal_error, fmt::format("internal error: {}", error.what()));
  }
}

}  // namespace

ExitCode run_program(std::span<const Command> commands, std::vector<std::string> arguments, Console console) {
  if (const auto unknown = unknown_command(commands, arguments))
    return complain(console, ExitCode::bad_case, *unknown);
  CLI::App app{"Jammed packings of bidisperse frictional spheres.", "furnas"};
  app.set_version_flag("--version", fmt::format("furnas {}", build_info().version));
  app.require_subcommand(1);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.footer(fmt::format("furnas COMMAND --help describes a command.\n\n{}", exit_codes));

  const Command* chosen = nullptr;
  for (const Command& command : commands) {
    CLI::App* app_of_command = app.add_subcommand(command.name, command.does);
    app_of_command->group("Commands");
    app_of_command->footer(fmt::format("Example:\n  {}", command.example));
    CommandLine line(*app_of_command);
    command.setup(line);
    app_of_command->callback([&chosen, &command] { chosen = &command; });
  }
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return answer(app, error, console);
  }
  return run_guarded(*chosen, console);
}

}  // namespace furnas
