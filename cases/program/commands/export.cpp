#include <memory>
#include <ostream>

#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "io/formats.h"

namespace furnas {

Command export_command() {
  struct Options {
    std::string source;
    std::optional<std::int64_t> frame;
    std::string format;
    std::string out;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "export";
  command.does = "write a packing in another format";
  command.example = "furnas export runs/first_packing lammps-data";
  command.setup = [options](CommandLine& app) {
    add_packing_source(app, options->source, options->frame);
    app.add("FORMAT", options->format, names_of_written_formats()).required();
    app.add("--out", options->out, "file; default: packing with the format's extension");
  };
  command.run = [options](Console console) {
    remark_on_older_checkpoint(options->source, console.err);
    const std::string out =
        options->out.empty() ? "packing" + std::string(extension_of(options->format)) : options->out;
    const Packing packing = packing_source(options->source, options->frame).packing;
    write_packing(packing, options->format, out);
    remark_on_losses(packing, options->format, console.err);
    console.out << out << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
