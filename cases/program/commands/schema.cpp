#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <ostream>
#include <string>

#include "cases/program/commands/command.h"
#include "cases/program/output_page.h"
#include "io/case_preset.h"
#include "io/case_schema.h"
#include "io/case_words.h"

namespace furnas {
namespace {

struct SchemaOptions {
  bool markdown = false;
  bool outputs = false;
};

std::string default_text(const Key& key) {
  const std::string value = value_text(key, Case{});
  return value.empty() ? fmt::format("left out; {} is used", key.rival) : value;
}

constexpr std::string_view sweep_doc =
    R"([sweep] turns one case into many, for `furnas sweep`: every combination of the values of its keys, each
with several seeds. A key is any key of the tables above, in quotes, with one value or a list of values;
`samples` (an integer, default 1) is the number of seeds, from mixture.seed on. Each [[sweep]] is a grid of
values of its own.

    [sweep]
    "mixture.small_fraction" = [0.1, 0.2, 0.3]
    "contact.friction" = [0.0, 0.3]
    samples = 4
)";

void print_text(std::ostream& out) {
  std::string_view table;
  for (const Key& key : case_keys()) {
    if (key.table != table) out << fmt::format("\n[{}]\n", key.table);
    table = key.table;
    out << fmt::format("  {} = {}\n", key.name, default_text(key));
    out << fmt::format("      {}\n", key.doc);
    out << fmt::format("      {}{}; allowed: {}\n", type_text(key),
                       key.unit.empty() ? "" : fmt::format(" in {}", key.unit), allowed_text(key));
  }
}

constexpr std::string_view introduction = R"(# The case file

A case is a TOML file. Every key has a default, so an empty file is a case; every key is checked for its type
and its range, and a key that is not listed here is an error. Lengths are in d_s (diameter of a small sphere),
masses in rho d_s^3, forces in k_n d_s; t_c is the collision time of two small spheres. A key is set from the
command line with `--set table.key=value`.

This page is written by `furnas schema --markdown`.
)";

void print_markdown(std::ostream& out) {
  constexpr std::string_view head =
      "| key | type | unit | default | allowed | meaning |\n|---|---|---|---|---|---|\n";
  out << introduction << "\n## preset\n\n" << head;
  std::string_view table;
  for (const Key& key : case_keys()) {
    if (key.table != table) out << fmt::format("\n## [{}]\n\n{}", key.table, head);
    table = key.table;
    out << fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", key.name, type_text(key), key.unit,
                       default_text(key), allowed_text(key), key.doc);
  }
  out << "\n## Presets\n\nA preset replaces the defaults of its keys. A value that the case gives replaces "
         "both.\n\n| preset | what it is | keys |\n|---|---|---|\n";
  for (const Preset& preset : presets())
    out << fmt::format("| `{}` | {} | `{}` |\n", preset.name, preset.does,
                       fmt::join(preset.assignments, "`, `"));
  out << "\n## [sweep]\n\n" << sweep_doc;
}

}  // namespace

Command schema_command() {
  const auto options = std::make_shared<SchemaOptions>();
  return {
      .name = "schema",
      .does = "list every key of the case file, or describe the files of runs and sweeps",
      .example = "furnas schema --markdown > docs/reference/case-file.md",
      .setup =
          [options](CommandLine& app) {
            app.flag("--markdown", options->markdown, "print the page docs/reference/case-file.md");
            app.flag("--outputs", options->outputs,
                     "every field, column and array of the files that runs and sweeps write, as the page "
                     "docs/reference/outputs.md");
          },
      .run =
          [options](Console console) {
            if (options->outputs) console.out << output_page();
            if (options->markdown) print_markdown(console.out);
            if (!options->outputs && !options->markdown) print_text(console.out);
            return ExitCode::done;
          },
  };
}

}  // namespace furnas
