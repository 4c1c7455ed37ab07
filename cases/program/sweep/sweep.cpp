#include "cases/program/sweep/sweep.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <ostream>
#include <set>

#include "cases/program/preflight.h"
#include "cases/program/run/progress.h"
#include "cases/program/run/recording.h"
#include "cases/program/run/run_folder.h"
#include "cases/program/run/signals.h"
#include "cases/program/sweep/base_case.h"
#include "cases/program/sweep/finite_size.h"
#include "cases/program/sweep/maxima.h"
#include "cases/program/sweep/points.h"
#include "cases/program/sweep/pool.h"
#include "cases/program/sweep/refinement.h"
#include "cases/program/sweep/thin_cells.h"
#include "cases/program/table.h"
#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Number of times that points are added around a maximum.
constexpr int most_refinements = 6;

/// The exit code of the sweep: that of the worst sample.
ExitCode code_of(const SampleTable& table) {
  const auto any = [&](auto is) { return std::any_of(table.rows.begin(), table.rows.end(), is); };
  const auto is_good = [](const SampleRow& row) { return row.jammed() || row.settled(); };
  const auto is_spent = [](const SampleRow& row) { return row.verdict == to_string(Verdict::budget); };
  if (any([&](const SampleRow& row) { return !is_good(row) && !is_spent(row); }))
    return ExitCode::samples_failed;
  return any(is_spent) ? ExitCode::budget_spent : ExitCode::done;
}

/// The progress of the sweep on one line, which is overwritten on a terminal; elsewhere a new line for each
/// sample.
class Line {
 public:
  explicit Line(std::ostream& out) : lines_(out, isatty(STDERR_FILENO) == 1) {}

  void show(const SweepStanding& s) {
    const auto since = Clock::now() - shown_;
    const auto pause = lines_.live() ? std::chrono::milliseconds(500) : std::chrono::seconds(10);
    if (s.done == done_ && since < pause) return;
    shown_ = Clock::now();
    done_ = s.done;
    lines_.show({fmt::format("{} of {} samples done{}  {} running{}  {} to come  about {} left{}", s.done,
                             s.done + s.running + s.elsewhere + s.left,
                             s.failed > 0 ? fmt::format(" ({} without phi_J)", s.failed) : "", s.running,
                             s.elsewhere > 0 ? fmt::format("  {} elsewhere", s.elsewhere) : "", s.left,
                             duration_text(s.seconds_left),
                             s.late > 0 ? fmt::format(", but for {} longer than estimated", s.late) : "")});
  }

  void finish() { lines_.clear(); }

 private:
  LiveLines lines_;
  Clock::time_point shown_{};
  std::optional<std::size_t> done_;
};

class Sweep {
 public:
  Sweep(const SweepOrder& order, Console console)
      : order_(order),
        console_(console),
        keys_(keys_of(order.file)),
        samples_(samples_of(order.file, keys_, order.folder)),
        worker_(order.folder, order.takeover),
        turns_(order.folder, worker_) {
    put(base_case_name, base_case_text(samples_, keys_));
    // Finished samples in the folder that the file does not list (any more) are included, but unfinished ones
    // are not run.
    for (Sample& sample : added_samples(samples_, keys_, order.folder))
      if (order.refine || state_of(sample) == SampleState::finished) samples_.push_back(std::move(sample));
  }

  ExitCode go() {
    const auto finished = std::count_if(samples_.begin(), samples_.end(), [](const Sample& sample) {
      return state_of(sample) == SampleState::finished;
    });
    if (finished > 0)
      console_.err << fmt::format("{} of {} samples are finished and not run again\n", finished,
                                  samples_.size());
    if (const std::size_t foreign = foreign_samples(); foreign > 0)
      console_.err << fmt::format(
          "{} sample{} in {} belong{} to no point of this sweep and {} not in its tables\n", foreign,
          foreign == 1 ? "" : "s", (order_.folder / "samples").string(), foreign == 1 ? "s" : "",
          foreign == 1 ? "is" : "are");
    Requests requests;
    const SignalGuard guard(requests);
    PoolEnd end = run(requests);
    for (int n = 0; end == PoolEnd::whole && order_.refine && n < most_refinements; ++n) {
      const std::vector<Sample> added = refining_samples(samples_, keys_, order_.folder);
      if (added.empty()) break;
      console_.err << fmt::format("{} samples more around the maxima\n", added.size());
      samples_.insert(samples_.end(), added.begin(), added.end());
      end = run(requests);
    }
    summarize();
    return tell(end);
  }

 private:
  /// Samples in the folder that an earlier call with other values has made.
  std::size_t foreign_samples() const {
    std::set<fs::path> own;
    for (const Sample& sample : samples_) own.insert(sample.folder);
    const std::vector<fs::path> files = resolved_cases_in(order_.folder);
    return static_cast<std::size_t>(std::count_if(
        files.begin(), files.end(), [&](const fs::path& file) { return !own.contains(file.parent_path()); }));
  }

  PoolEnd run(Requests& requests) {
    Line line(console_.err);
    std::optional<std::size_t> done;
    Clock::time_point next{};
    const PoolLimits limits{order_.jobs, deadline(), order_.waits};
    const PoolEnd end = run_samples(samples_, limits, worker_, turns_, requests, [&](const SweepStanding& s) {
      line.show(s);
      const auto now = Clock::now();
      if (s.done == done || now < next) return;
      write_tables();
      done = s.done;
      next = Clock::now() + 20 * (Clock::now() - now);  // reading the files of many samples takes time
    });
    line.finish();
    // The last tables must include samples that other workers have ended meanwhile, because those workers may
    // have written their tables earlier.
    while (write_tables() != csv(table_of(samples_, keys_))) {
    }
    if (end == PoolEnd::whole) Watch(worker_).remove_ended();
    return end;
  }

  /// The deadline for samples: some seconds before the wall time is over, so that tables can be written.
  std::optional<Clock::time_point> deadline() const {
    if (!order_.walltime) return {};
    const std::chrono::duration<double> all = *order_.walltime;
    return begin_ + std::chrono::duration_cast<Clock::duration>(
                        all - std::min(0.1 * all, std::chrono::duration<double>(10)));
  }

  ExitCode tell(PoolEnd end) const {
    switch (end) {
      case PoolEnd::whole:
        return code_of(table_of(samples_, keys_));
      case PoolEnd::elsewhere:
        console_.err << "the samples that are left are run by other workers on this folder\n";
        return ExitCode::done;
      case PoolEnd::out_of_time:
        console_.err << "the wall time is spent; all samples are saved, and the same command, given again, "
                        "continues them\n";
        return ExitCode::samples_left;
      case PoolEnd::stopped:
        break;
    }
    console_.err
        << "stopped by a signal; all samples are saved, and the same command, given again, continues them\n";
    return ExitCode::interrupted;
  }

  /// Returns the text of sweep.csv.
  std::string write_tables() const {
    const SampleTable table = table_of(samples_, keys_);
    const std::vector<Point> points = points_of(table);
    std::string text = csv(table);
    put(sample_table_name, text);
    put("points.csv", csv(points, keys_));
    put("maxima.csv", maxima_csv(curves_of(points, keys_), keys_));
    return text;
  }

  /// Other workers write the same file, so each writes to a file of its own and renames it when it is
  /// complete.
  void put(const char* name, const std::string& text) const {
    const fs::path own = worker_.own_file(name), place = order_.folder / name;
    write_file(own, text);
    std::error_code error;
    fs::rename(own, place, error);
    if (!error) return;
    fs::remove(own);
    throw OutputError(
        fmt::format("{}: cannot put the file in its place: {}", place.string(), error.message()));
  }

  void summarize() const {
    const SampleTable table = table_of(samples_, keys_);
    Table text({"point", "samples", "jammed", "settled", "phi_J", "+- (95 %)", "finite size", "Z backbone",
                "effective size", "thickness"});
    for (const Point& p : points_of(table)) {
      const auto& phi = p.mean_phi_J;
      text.row(
          {fmt::format("{}", fmt::join(p.values, " ")), std::to_string(p.samples), std::to_string(p.jammed),
           std::to_string(p.settled), phi ? fmt::format("{:.5f}", phi->mean) : "-",
           phi && phi->samples > 1 ? fmt::format("{:.5f}", phi->half_width) : "-",
           phi ? finite_size_text(p) : "-",
           p.mean_Z_backbone ? fmt::format("{:.3f}", p.mean_Z_backbone->mean) : "-",
           fmt::format("{:.0f}", p.effective_size), thickness_text(p) + (p.too_thin() ? ", too thin" : "")});
    }
    const Case& c = samples_.front().resolved_case;
    console_.out << fmt::format("points of {} (p_a {}, preset {})\n", fmt::join(keys_, " "),
                                fmt::join(c.compaction.pressure, " "), c.preset)
                 << text.aligned();
    const std::vector<Curve> curves = curves_of(points_of(table), keys_);
    for (const Curve& curve : curves)
      if (const auto m = maximum_of(curve))
        console_.out << fmt::format(
            "alpha {:g}, mu {:g}: f_max {:.3f} (95 %: {:.3f} to {:.3f}), phi_max {:.4f}\n",
            curve.size_ratio(), curve.friction(), m->f_max, m->f_max_low, m->f_max_high, m->phi_max.mean);
    for (const SampleRow& row : table.rows)
      if (row.settled())
        console_.out << fmt::format("{} seed {}: settled, phi {:.5f} +- {:.1e} (bound)\n",
                                    fmt::join(row.values, " "), row.seed, row.phi, row.phi_bound);
      else if (!row.jammed())
        console_.out << fmt::format("{} seed {}: {}{}\n", fmt::join(row.values, " "), row.seed, row.verdict,
                                    row.reason.empty() ? "" : fmt::format(" ({})", row.reason));
    console_.out << fmt::format("files  {}: {} points.csv maxima.csv\n", order_.folder.string(),
                                sample_table_name)
                 << std::flush;
  }

  const SweepOrder& order_;
  Console console_;
  const Clock::time_point begin_ = Clock::now();
  std::vector<std::string> keys_;
  std::vector<Sample> samples_;
  const Worker worker_;
  Turns turns_;
};

}  // namespace

ExitCode run_sweep(const SweepOrder& order, Console console) {
  if (!Checkpoints::none(order.folder))
    throw InputError(fmt::format("--out {} is the folder of a run; allowed: a new folder, or that of a sweep",
                                 order.folder.string()));
  samples_of(order.file, keys_of(order.file), order.folder);  // throws before any folder is made
  make_folder(order.folder);
  return Sweep(order, console).go();
}

std::string sweep_report(const SweepFile& sweep) {
  const std::vector<Sample> samples = samples_of(sweep, keys_of(sweep), {});
  double cost = 0, longest = 0;
  std::set<fs::path> points;
  double largest = 0, memory = 0;
  std::string refusals;
  for (const Sample& sample : samples) {
    cost += sample.cost();
    longest = std::max(longest, sample.cost());
    largest = std::max(largest, sample.particles);
    memory = std::max(memory, expected_memory(sample.particles, sample.resolved_case));
    if (!points.insert(sample.folder.parent_path()).second) continue;
    const std::string refusal = check_case(sample.resolved_case).refusal;
    if (!refusal.empty())
      refusals += fmt::format("refused   {}: {}\n", sample.folder.parent_path().filename().string(), refusal);
  }
  const double seconds = cost / pace_of_a_core;
  return fmt::format(
      "samples   {} at {} points\n"
      "particles at most {:.0f} in a sample, about {:.2f} GB\n"
      "time      about {} on one core, {} on the {} of this machine; the longest sample {} on one core\n{}",
      samples.size(), points.size(), largest, memory / 1e9, duration_text(seconds),
      duration_text(seconds / available_threads()), available_threads(),
      duration_text(longest / pace_of_a_core), remark_on_thin_cells(samples) + refusals);
}

}  // namespace furnas
