#include <memory>
#include <ostream>

#include "cases/commands/command.h"
#include "cases/packing_source.h"
#include "viz/picture.h"

namespace furnas {

Command render_command() {
  struct Options {
    std::string source;
    std::string out = "packing.png";
    int size = 2000;
    bool transparent = false;
    bool no_cell = false;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "render";
  command.does = "draw a packing, without a display";
  command.example = "furnas render runs/first_packing --out packing.png --transparent";
  command.setup = [options](CLI::App& app) {
    add_packing_source(app, options->source);
    app.add_option("--out", options->out, "PNG file")->capture_default_str();
    app.add_option("--size", options->size, "edge of the picture in pixels")
        ->check(CLI::Range(16, 16384))
        ->capture_default_str();
    app.add_flag("--transparent", options->transparent, "no background instead of a white one");
    app.add_flag("--no-cell", options->no_cell, "leave out the edges of the periodic cell");
  };
  command.run = [options](Console console) {
    PictureOptions picture;
    picture.width = picture.height = options->size;
    picture.transparent = options->transparent;
    picture.cell = !options->no_cell;
    render_png(packing_from(options->source), options->out, picture);
    console.out << options->out << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
