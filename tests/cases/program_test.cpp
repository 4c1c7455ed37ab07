#include "cases/program/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "cases/program/run/folder_lock.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

using testing::HasSubstr;

/// A command that does what the test says.
Command command_that(std::function<ExitCode(Console)> run) {
  return {"act", "does what the test says", "furnas act", [](CommandLine&) {}, std::move(run)};
}

Answer ask(const Command& command, const std::vector<std::string>& arguments) {
  std::ostringstream out, err;
  const std::vector<Command> commands = {command};
  const ExitCode code = run_program(commands, arguments, {out, err});
  return {code, out.str(), err.str()};
}

template <class Error>
Command command_that_throws(const Error& error) {
  return command_that([error](Console) -> ExitCode { throw error; });
}

TEST(Program, HandsOnTheCodeOfTheCommand) {
  for (const ExitCode code :
       {ExitCode::done, ExitCode::refused, ExitCode::budget_spent, ExitCode::interrupted})
    EXPECT_EQ(ask(command_that([code](Console) { return code; }), {"act"}).code, code);
}

TEST(Program, TurnsErrorsIntoOneLineAndACode) {
  const auto input = ask(command_that_throws(InputError("case.toml:3: no\nsuch")), {"act"});
  EXPECT_EQ(input.code, ExitCode::bad_case);
  EXPECT_EQ(input.err, "furnas: case.toml:3: no such\n");
  const auto contract = ask(command_that_throws(ContractError("a.cpp:1: broken")), {"act"});
  EXPECT_EQ(contract.code, ExitCode::internal_error);
  EXPECT_EQ(contract.err, "furnas: internal error: a.cpp:1: broken\n");
  const auto memory = ask(command_that_throws(std::bad_alloc()), {"act"});
  EXPECT_EQ(memory.code, ExitCode::out_of_memory);
  EXPECT_EQ(memory.err, "furnas: out of memory\n");
}

TEST(Program, TellsWhatCannotBePrinted) {
  const std::vector<Command> commands = {command_that([](Console console) {
    console.out << "result";
    return ExitCode::done;
  })};
  std::ofstream full("/dev/full");
  if (!full) GTEST_SKIP();
  std::ostringstream err;
  EXPECT_EQ(run_program(commands, {"act"}, {full, err}), ExitCode::output_failed);
  EXPECT_EQ(err.str(), "furnas: cannot write to the standard output\n");
}

TEST(Program, FaultsOfTheSurroundingsHaveTheirCodes) {
  EXPECT_EQ(ask(command_that_throws(OutputError("a: disk full")), {"act"}).code, ExitCode::output_failed);
  EXPECT_EQ(ask(command_that_throws(FolderInUse("a is in use")), {"act"}).code, ExitCode::folder_in_use);
  const auto code_of = [](std::errc fault) {
    const std::filesystem::filesystem_error error("status", "a", std::make_error_code(fault));
    return ask(command_that_throws(error), {"act"}).code;
  };
  EXPECT_EQ(code_of(std::errc::not_enough_memory), ExitCode::out_of_memory);
  EXPECT_EQ(code_of(std::errc::no_space_on_device), ExitCode::output_failed);
  for (const std::errc fault :
       {std::errc::permission_denied, std::errc::filename_too_long, std::errc::too_many_symbolic_link_levels})
    EXPECT_EQ(code_of(fault), ExitCode::bad_case);
}

TEST(Program, AWrongCommandLineIsABadCase) {
  const Command act = command_that([](Console) { return ExitCode::done; });
  for (const auto& [arguments, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{}, "a command is missing; allowed: act"},
           {{"atc"}, "atc is no command; allowed: act"},
           {{"--bogus"}, "see furnas --help"},
           {{"act", "--bogus"}, "--bogus; see furnas act --help"}}) {
    const Answer answer = ask(act, arguments);
    EXPECT_EQ(answer.code, ExitCode::bad_case);
    EXPECT_THAT(answer.err, HasSubstr(expected));
    EXPECT_EQ(answer.err.find('\n'), answer.err.size() - 1);
  }
}

TEST(Program, HelpShowsTheTableAndTheExample) {
  const Command act = command_that([](Console) { return ExitCode::internal_error; });
  const Answer table = ask(act, {"--help"});
  EXPECT_EQ(table.code, ExitCode::done);
  EXPECT_THAT(table.out, HasSubstr("does what the test says"));
  EXPECT_THAT(table.out, HasSubstr("  130  stopped by a signal, and saved"));
  const Answer help = ask(act, {"act", "--help"});
  EXPECT_EQ(help.code, ExitCode::done);
  EXPECT_THAT(help.out, HasSubstr("Example:\n  furnas act"));
  EXPECT_THAT(ask(act, {"--version"}).out, HasSubstr("furnas "));
}

}  // namespace
}  // namespace furnas
