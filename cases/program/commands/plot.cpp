#include "cases/program/figures/plot.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <ostream>

#include "cases/program/chart_files.h"
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

/// The extension of the file determines the format; without one all three formats are written. Returns the
/// names of the files that were written, which are beside `file`.
std::vector<std::string> write(const Plot& plot, const fs::path& file, Console console) {
  const std::string extension = file.extension().string(), name = file.filename().string();
  if (extension == ".svg") return render_svg(plot.chart, file), std::vector{name};
  if (extension == ".png") return render_png(plot.chart, file), std::vector{name};
  const std::string table = extension == ".csv" ? name : name + ".csv";
  write_file(file.parent_path() / table, csv(plot.chart, plot.x, plot.y));
  std::vector<std::string> written{table};
  if (extension == ".csv") return written;
  for (std::string& chart : write_chart(plot.chart, file.parent_path(), name, console))
    written.push_back(std::move(chart));
  return written;
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
    const std::string format = fs::path(options->out).extension().string();
    if (!options->out.empty() && !format.empty() && format != ".svg" && format != ".png" && format != ".csv")
      throw InputError(
          fmt::format("--out {}: allowed: a name that ends with .svg, .png or .csv, or one without extension",
                      options->out));
    const Plot plot = plot_of(options->order);
    for (const std::string& remark : plot.remarks) console.err << fmt::format("furnas: {}\n", remark);
    const fs::path file = options->out.empty() ? fs::path(options->order.sweeps.front()) / "plots" / plot.name
                                               : fs::path(options->out);
    if (file.has_parent_path()) make_folder(file.parent_path());
    for (const std::string& written : write(plot, file, console))
      console.out << (file.parent_path() / written).string() << '\n';
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
