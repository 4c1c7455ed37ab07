#include <memory>
#include <ostream>

#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "io/formats.h"

namespace furnas {
namespace {

void describe(const Packing& packing, Console console) {
  std::size_t large = 0;
  for (Species s : packing.species) large += s == Species::large;
  console.out << packing.size() << " particles, " << large << " large, packing fraction "
              << packing.fraction_filled() << '\n';
}

}  // namespace

Command import_command() {
  struct Options {
    std::string source;
    std::string out;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "import";
  command.does = "read a packing, say what it is and keep it as a file that furnas starts from";
  command.example = "furnas import packing.lammpstrj --out start.vtp";
  command.setup = [options](CommandLine& app) {
    app.add("FILE", options->source, "packing in one of: " + names_of_read_formats()).required();
    app.add("--out", options->out, "file to write, format by its extension; default: only describe");
  };
  command.run = [options](Console console) {
    const Packing packing = read_packing(options->source);
    describe(packing, console);
    if (options->out.empty()) return ExitCode::done;
    const std::string_view format = format_by_extension(options->out);
    make_folder_of(options->out);
    write_packing(packing, format, options->out);
    console.out << options->out << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
