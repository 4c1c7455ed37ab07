#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <ostream>

#include "cases/program/bench/panels/error_panel.h"
#include "cases/program/bench/panels/panel.h"
#include "cases/program/bench/peers.h"
#include "cases/program/bench/prepare.h"
#include "cases/program/bench/roofline.h"
#include "cases/program/bench/speed.h"
#include "cases/program/bench/tradeoff/tradeoff.h"
#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "cases/program/run/run_folder.h"
#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// Options of all subcommands, and the subcommands themselves.
struct BenchOptions {
  std::optional<CommandLine> speed;
  std::optional<CommandLine> error;
  std::optional<CommandLine> peers;
  std::optional<CommandLine> prepare;
  std::optional<CommandLine> tradeoff;
  std::vector<CommandLine> panels;  ///< in the order of panels()

  PackingChoice packings;
  std::vector<double> friction{0.3};
  std::vector<int> threads;
  std::vector<std::string> precision{"mixed"};
  SpeedOrder measure;
  double triad_megabytes = 0;
  std::string csv;
  PeersOrder match;
  PrepareOrder making;
  TradeoffOrder arms;
  fs::path error_folder;  ///< empty: no files
  fs::path panel_folder = "runs/panels";
  bool quick = false;
};

/// One thread, and all threads of the computer.
std::vector<int> usual_threads() {
  const int all = available_threads();
  return all > 1 ? std::vector{1, all} : std::vector{1};
}

void declare_speed(CommandLine& bench, BenchOptions& o) {
  o.speed = bench.subcommand("speed", "million particle-steps per second, and the error of the forces");
  o.threads = usual_threads();
  add_packing_choice(*o.speed, o.packings);
  o.speed->add("--friction", o.friction, "contact.friction").separated_by(',').showing_default();
  o.speed->add("--law", o.measure.law, "contact.law").showing_default();
  o.speed->add("--threads", o.threads, "numbers of threads")
      .separated_by(',')
      .between(1, 1024)
      .showing_default();
  o.speed->add("--precision", o.precision, "compute.precision").separated_by(',').showing_default();
  o.speed->add("--seconds", o.measure.seconds, "duration of a repeat with the first number of threads [s]")
      .above_zero()
      .showing_default();
  o.speed->add("--steps", o.measure.steps, "length of a repeat in steps, instead of --seconds").above_zero();
  o.speed
      ->add("--repeats", o.measure.repeats,
            "repeats; each runs all numbers of threads and precisions in turn")
      .above_zero()
      .showing_default();
  o.speed
      ->add("--triad", o.triad_megabytes,
            "megabytes of each array of the bandwidth test; default: four times the last-level cache, at "
            "most 512")
      .above_zero();
  o.speed->add("--csv", o.csv, "file for the results with all digits");
}

void declare_error(CommandLine& bench, BenchOptions& o) {
  o.error = bench.subcommand("error", "how far the forces are from those in long double");
  add_packing_choice(*o.error, o.packings);
  o.error->add("--friction", o.friction, "contact.friction").separated_by(',').showing_default();
  o.error->add("--law", o.measure.law, "contact.law").showing_default();
  o.error->add("--precision", o.precision, "compute.precision").separated_by(',').showing_default();
  o.error->add("--out", o.error_folder, "folder for the table and a chart");
}

void declare_peers(CommandLine& bench, BenchOptions& o) {
  o.peers =
      bench.subcommand("peers", "speed of furnas and of an installed LAMMPS on the same packing, in turn");
  o.match.ranks = available_threads();
  add_packing_source(*o.peers, o.match.source, o.match.frame);
  o.peers->add("--steps", o.match.steps, "length of a run").above_zero().showing_default();
  o.peers->add("--pairs", o.match.pairs, "runs of each program").above_zero().showing_default();
  o.peers->add("--law", o.match.model.law, "law of furnas; LAMMPS has hooke_history").showing_default();
  o.peers->add("--friction", o.match.model.friction, "contact.friction of both").showing_default();
  o.peers->add("--precision", o.match.model.precision, "compute.precision of furnas").showing_default();
  o.peers->add("--ranks", o.match.ranks, "ranks of LAMMPS and threads of furnas")
      .between(1, 1024)
      .showing_default();
  o.peers->add("--skins", o.match.skins, "skins that LAMMPS tries [d_s]").separated_by(',').showing_default();
  o.peers->add("--out", o.match.folder,
               "folder for the files of LAMMPS, which is kept; default: a temporary one");
}

void declare_prepare(CommandLine& bench, BenchOptions& o) {
  o.prepare = bench.subcommand("prepare", "make the packings for bench speed and bench error");
  o.making.ratios = benchmark_ratios();
  o.prepare->add("--out", o.making.folder, "folder for the packings").showing_default();
  o.prepare->add("--ratios", o.making.ratios, "size ratios").separated_by(',').showing_default();
  o.prepare
      ->add("--sizes", o.making.sizes,
            "also write packings repeated to these numbers of particles; bench speed does not need them")
      .separated_by(',');
  o.prepare->add("--set", o.making.set, "change a key of the cases, e.g. compute.threads=2");
  o.prepare->add("--walltime", o.making.walltime, "stop each case and save after e.g. 30m or 2h");
}

void declare_tradeoff(CommandLine& bench, BenchOptions& o) {
  o.tradeoff =
      bench.subcommand("tradeoff", "compare settings: seconds to the end of a run, and phi with its error");
  o.arms.jobs = available_threads();
  o.tradeoff->add("FILE", o.arms.file, "cases and arms, as cases/tradeoff.toml").required();
  o.tradeoff
      ->add("--out", o.arms.folder,
            "folder for samples, tables and charts; if it exists, its samples are continued")
      .required();
  o.tradeoff->add("--jobs", o.arms.jobs, "threads of all samples together; default: all of the machine")
      .between(1, 1024);
  o.tradeoff
      ->add("--samples", o.arms.samples, "number of seeds of each arm, instead of the number in the file")
      .between(1, 100'000);
  o.tradeoff->add("--cases", o.arms.cases, "only these cases").separated_by(',');
  o.tradeoff->add("--arms", o.arms.arms, "only these arms, and the reference").separated_by(',');
  o.tradeoff->flag("--report", o.arms.report_only,
                   "run nothing; write tables and charts of the samples in the folder");
}

void declare_panels(CommandLine& bench, BenchOptions& o) {
  for (const Panel& panel : panels()) {
    CommandLine& app = o.panels.emplace_back(bench.subcommand(panel.name, panel.does));
    app.add("--out", o.panel_folder, "folder for table and chart").showing_default();
    app.flag("--quick", o.quick,
             "fewer points, in about a second: enough to check orders of convergence and closed forms");
  }
}

ExitCode speed(BenchOptions& o, Console console) {
  for (const std::string& precision : o.precision)
    for (const int threads : o.threads) o.measure.variants.push_back({precision, threads});
  std::vector<SpeedRow> rows;
  for_each_packing(o.packings, console, [&](const std::string& name, const Packing& packing) {
    for (const double friction : o.friction) {
      o.measure.friction = friction;
      for (SpeedRow& row : measure_speed(name, packing, o.measure)) {
        console.err << fmt::format("{}, {} particles, {}, {} thread(s): {}\n", name, row.particles,
                                   row.variant.precision, row.variant.threads, text_of(row.rate));
        rows.push_back(std::move(row));
      }
    }
  });
  std::map<int, double> bandwidth;
  const std::size_t bytes =
      o.triad_megabytes > 0 ? static_cast<std::size_t>(o.triad_megabytes * 1e6) : triad_size();
  for (const int threads : o.threads) {
    bandwidth[threads] = triad_bandwidth(threads, bytes);
    console.out << fmt::format("triad {:.1f} GB/s with {} thread(s), arrays of {} MB\n",
                               bandwidth[threads] / 1e9, threads, bytes / 1'000'000);
  }
  std::vector<double> bounds;
  for (const SpeedRow& row : rows) bounds.push_back(bandwidth[row.variant.threads]);
  console.out << speed_table(rows, bounds).aligned() << '\n' << phase_lines(rows);
  if (!o.csv.empty()) write_file(o.csv, speed_csv(rows, bounds).csv());
  return ExitCode::done;
}

ExitCode error(BenchOptions& o, Console console) {
  std::vector<ForceErrorRow> rows;
  for_each_packing(o.packings, console, [&](const std::string& name, const Packing& packing) {
    for (const double friction : o.friction)
      for (const std::string& precision : o.precision)
        rows.push_back({name, packing.size(), friction, precision,
                        force_error(model_for({o.measure.law, friction, precision}, packing), packing)});
  });
  const PanelResult result = panel_of(rows);
  if (o.error_folder.empty())
    console.out << result.table.aligned();
  else
    show_panel("error", result, o.error_folder, console);
  return ExitCode::done;
}

ExitCode peers(BenchOptions& o, Console console) {
  const bool temporary = o.match.folder.empty();
  if (temporary) o.match.folder = fs::temp_directory_path() / fmt::format("furnas_peers_{}", ::getpid());
  make_folder(o.match.folder);
  const ExitCode code = compare_with_lammps(o.match, console);
  if (temporary) fs::remove_all(o.match.folder);  // after a failure the exception keeps the folder
  return code;
}

ExitCode show(const Panel& panel, BenchOptions& o, Console console) {
  show_panel(panel.name, panel.make(o.quick ? Effort::quick : Effort::full), o.panel_folder, console);
  return ExitCode::done;
}

}  // namespace

Command bench_command() {
  const auto options = std::make_shared<BenchOptions>();
  return {
      .name = "bench",
      .does = "measure speed and error, and compare the speed with LAMMPS",
      .example = "furnas bench prepare --ratios 1,5 && furnas bench speed --ratios 1,5 --sizes 1e4",
      .setup =
          [options](CommandLine& app) {
            declare_prepare(app, *options);
            declare_speed(app, *options);
            declare_error(app, *options);
            declare_peers(app, *options);
            declare_tradeoff(app, *options);
            declare_panels(app, *options);
          },
      .run =
          [options](Console console) {
            if (options->prepare->parsed()) return prepare_packings(options->making, console);
            if (options->speed->parsed()) return speed(*options, console);
            if (options->error->parsed()) return error(*options, console);
            if (options->tradeoff->parsed()) return run_tradeoff(options->arms, console);
            for (std::size_t k = 0; k < panels().size(); ++k)
              if (options->panels[k].parsed()) return show(panels()[k], *options, console);
            return peers(*options, console);
          },
  };
}

}  // namespace furnas
