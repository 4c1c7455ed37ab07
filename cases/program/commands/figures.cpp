#include "cases/program/figures/figures.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <ostream>

#include "cases/program/chart_files.h"
#include "cases/program/commands/command.h"
#include "cases/program/figures/report.h"
#include "cases/program/run/run_folder.h"
#include "io/atomic_file.h"

namespace furnas {

Command figures_command() {
  struct Options {
    std::vector<std::string> folders;
    std::string out;
    bool no_pictures = false;
  };
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "figures";
  command.does = "draw the paper's figures from sweeps, and report which of its statements are reproduced";
  command.example = "furnas figures runs/mono runs/alpha_5 --out figures";
  command.setup = [options](CommandLine& app) {
    app.add("SWEEP", options->folders, "folders of sweeps").required();
    app.add("--out", options->out, "folder for the files; default: figures in the first sweep's");
    app.flag("--no-pictures", options->no_pictures, "write the tables and the report alone");
  };
  command.run = [options](Console console) {
    namespace fs = std::filesystem;
    const Study study = study_of({options->folders.begin(), options->folders.end()});
    const fs::path folder =
        options->out.empty() ? fs::path(options->folders.front()) / "figures" : fs::path(options->out);
    const std::vector<Figure> figures = figures_of(study);
    make_folder(folder);
    for (const Figure& figure : figures) {
      write_file(folder / (figure.name + ".csv"), csv(figure.chart));
      if (!options->no_pictures) write_chart(figure.chart, folder, figure.name, console);
    }
    write_file(folder / "report.md", report(study, figures));
    for (const std::string& remark : study.remarks) console.err << fmt::format("furnas: {}\n", remark);
    if (study.history.empty())
      console.err << "furnas: no figure_1b_history: no jammed sample has a history.csv in these folders\n";
    console.out << fmt::format("{} figures and report.md in {}\n", figures.size(), folder.string());
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
