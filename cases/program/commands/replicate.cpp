#include <memory>
#include <ostream>

#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "cases/program/replication.h"
#include "io/formats.h"

namespace furnas {

Command replicate_command() {
  struct Options {
    std::string source;
    std::optional<std::int64_t> frame;
    std::string out;
    std::string times;
    bool start = false;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "replicate";
  command.does = "repeat a packing along the edges of its cell";
  command.example = "furnas replicate runs/first_packing large.checkpoint --times 2x2x2";
  command.setup = [options](CommandLine& app) {
    add_packing_source(app, options->source, options->frame);
    app.add("OUT", options->out,
            "file to write, format by its extension: checkpoint, which keeps contacts and histories, " +
                names_of_written_formats())
        .required();
    app.add("--times", options->times, "how often along each edge, e.g. 2x2x2").required();
    app.flag("--start", options->start,
             "leave out contacts and forces; this needs a third of the memory, and a run that starts from "
             "the file computes new forces, without histories");
  };
  command.run = [options](Console console) {
    remark_on_older_checkpoint(options->source, console.err);
    const Times times = parse_times(options->times);
    PackingSource source = packing_source(options->source, options->frame);
    if (options->start) {
      source.packing.contacts.clear();
      source.packing.order.clear();
    }
    make_folder_of(options->out);
    write_replicate(source, times, options->out);
    if (std::filesystem::path(options->out).extension() != ".checkpoint")
      remark_on_losses(source.packing, format_by_extension(options->out), console.err);
    console.out << options->out << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
