#include "cases/program/figures/plot.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <ostream>

#include "cases/program/commands/command.h"
#include "cases/program/figures/figures.h"
#include "cases/program/run/run_folder.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  std::vector<std::string> sweeps;
  PlotOrder order;
  std::string out;
};

/// The extension of a file name determines the format; without an extension all three formats are written.
std::vector<fs::path> files_of(const std::string& out, const Plot& plot, const fs::path& sweep) {
  const fs::path base = out.empty() ? sweep / "plots" / plot.name : fs::path(out);
  const std::string extension = base.extension().string();
  if (extension == ".csv" || extension == ".svg" || extension == ".png") return {base};
  return {base.string() + ".csv", base.string() + ".svg", base.string() + ".png"};
}

void write(const Plot& plot, const fs::path& file) {
  if (file.extension() == ".csv") write_file(file, csv(plot.chart, plot.x, plot.y));
  if (file.extension() == ".svg") render_svg(plot.chart, file);
  if (file.extension() == ".png") render_png(plot.chart, file);
}

}  // namespace

Command plot_command() {
  auto options = std::make_shared<PlotOptions>();
  Command command;
  command.name = "plot";
  command.does = "draw a column of sweeps against a key of the case, with 95 % intervals and the model";
  command.example = "furnas plot runs/mono runs/alpha_5 --x small_fraction --y phi_J --by friction";
  command.setup = [options](CommandLine& app) {
    app.add("SWEEP", options->sweeps, "folders of sweeps").required();
    app.add("--x", options->order.x, "key of the case; default: small_fraction, or the only one that varies");
    app.add("--y", options->order.y,
            "mean of points.csv, column of sweep.csv or number of result.json (\"stress.xx\")")
        .showing_default();
    app.add("--by", options->order.by, "keys that differ between curves; default: all other keys that vary");
    app.add("--where", options->order.where, "key=value: only the samples with this value");
    app.add("--out", options->out,
            "file.svg, file.png or file.csv, or a name for all three; default: plots/ in the first sweep's");
  };
  command.run = [options](Console console) {
    options->order.sweeps = {options->sweeps.begin(), options->sweeps.end()};
    const Plot plot = plot_of(options->order);
    for (const std::string& remark : plot.remarks) console.err << fmt::format("furnas: {}\n", remark);
    for (const fs::path& file : files_of(options->out, plot, options->order.sweeps.front())) {
      if (file.has_parent_path()) make_folder(file.parent_path());
      write(plot, file);
      console.out << file.string() << '\n';
    }
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
