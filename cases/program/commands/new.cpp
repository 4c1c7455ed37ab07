#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <string_view>

#include "cases/program/case_templates.h"
#include "cases/program/commands/command.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

struct Name {
  std::string_view name;  ///< what the user types
  std::string_view file;  ///< the case file in cases/ of this name
};

constexpr auto templates = std::to_array<Name>({
    {"mono", "first_packing"},
    {"frictionless", "frictionless"},
    {"bidisperse", "bidisperse_5"},
    {"paper", "paper"},
    {"smoke", "smoke"},
});

struct NewOptions {
  std::string name;
  std::string file;
};

std::string_view text_of(const Name& name) {
  const auto all = case_templates();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& known) { return known.file == name.file; });
  require(found != all.end(), "each template names a case file of cases/");
  return found->text;
}

/// The first line of the file, which says what the case shows.
std::string title(const Name& name) {
  const std::string_view text = text_of(name);
  return std::string(text.substr(2, text.find('\n') - 2));
}

std::string list_of_templates() {
  std::string list;
  for (const Name& name : templates) list += fmt::format("\n  {:<14}{}", name.name, title(name));
  return list;
}

std::string known_names() {
  std::string list;
  for (const Name& name : templates) list += fmt::format("{}{}", list.empty() ? "" : ", ", name.name);
  return list;
}

ExitCode run(const NewOptions& options, Console console) {
  const auto* const name = std::find_if(templates.begin(), templates.end(),
                                        [&](const Name& known) { return known.name == options.name; });
  if (name == templates.end())
    throw InputError(fmt::format("TEMPLATE = {} is unknown; allowed: {}", options.name, known_names()));
  const std::string file = options.file.empty() ? options.name + ".toml" : options.file;
  refuse_existing(file);
  write_file(file, text_of(*name));
  console.out << fmt::format("{}: {}\nnext: furnas run {}\n", file, title(*name), file);
  return ExitCode::done;
}

}  // namespace

Command new_command() {
  const auto options = std::make_shared<NewOptions>();
  return {
      .name = "new",
      .does = "write a commented case file to start from",
      .example = "furnas new mono my_packing.toml",
      .setup =
          [options](CommandLine& app) {
            app.add("TEMPLATE", options->name, "one of" + list_of_templates()).required();
            app.add("FILE", options->file, "file to write; TEMPLATE.toml if left out, never overwritten");
          },
      .run = [options](Console console) { return run(*options, console); },
  };
}

}  // namespace furnas
