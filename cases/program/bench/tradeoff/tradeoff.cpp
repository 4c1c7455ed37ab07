#include "cases/program/bench/tradeoff/tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <set>

#include "cases/program/bench/tradeoff/comparison.h"
#include "cases/program/bench/tradeoff/work_precision.h"
#include "cases/program/build_info.h"
#include "cases/program/chart_files.h"
#include "cases/program/run/folder_lock.h"
#include "cases/program/run/progress.h"
#include "cases/program/run/recording.h"
#include "cases/program/run/run_folder.h"
#include "cases/program/run/signals.h"
#include "cases/program/sweep/pool.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

class Tradeoff {
 public:
  Tradeoff(TradeoffFile file, const TradeoffOrder& order, Console console)
      : file_(std::move(file)),
        order_(order),
        console_(console),
        samples_(tradeoff_samples(file_, order.folder)) {}

  ExitCode go() {
    bool whole = true;
    if (!order_.report_only) {
      tell_finished();
      whole = run();
    }
    write_tables();
    draw();
    console_.out << comparison_table(compared()).aligned();
    console_.out << fmt::format("files  {}: tradeoff.csv samples.csv, a chart for each case\n",
                                order_.folder.string())
                 << std::flush;
    if (whole) return ExitCode::done;
    console_.err
        << "stopped by a signal; all samples are saved, and the same command, given again, continues them\n";
    return ExitCode::interrupted;
  }

 private:
  void tell_finished() const {
    const auto finished = std::count_if(samples_.begin(), samples_.end(), [](const Sample& sample) {
      return state_of(sample) == SampleState::finished;
    });
    console_.err << fmt::format("{} samples, {} of them finished and not run again\n", samples_.size(),
                                finished);
  }

  bool run() const {
    Requests requests;
    const SignalGuard guard(requests);
    const Worker worker(order_.folder, usual_takeover);
    Turns turns(order_.folder, worker);
    PoolLimits limits;
    limits.jobs = order_.jobs;
    std::optional<std::size_t> done;
    const auto tell = [&](const SweepStanding& s) {
      if (s.done == done) return;
      done = s.done;
      console_.err << fmt::format("{} of {} samples done  about {} left\n", s.done, samples_.size(),
                                  duration_text(s.seconds_left))
                   << std::flush;
      write_tables();
    };
    return run_samples(samples_, limits, worker, turns, requests, tell) == PoolEnd::whole;
  }

  SampleTable table() const { return table_of(samples_, {"case", "arm"}); }
  std::vector<ComparedCase> compared() const { return compare(file_, table()); }

  void write_tables() const {
    write_file(order_.folder / "samples.csv", csv(table()));
    write_file(order_.folder / "tradeoff.csv",
               comparison_csv(compared(), std::string(build_info().version)).csv());
  }

  void draw() const {
    for (const ComparedCase& c : compared()) {
      const Chart chart = work_precision_chart(c);
      if (chart.series.empty()) {
        console_.err << fmt::format("furnas: no chart of {}: its reference {} has no phi\n", c.name,
                                    c.reference);
        continue;
      }
      write_chart(chart, order_.folder, c.name, console_);
    }
  }

  const TradeoffFile file_;
  const TradeoffOrder& order_;
  Console console_;
  const std::vector<Sample> samples_;
};

}  // namespace

std::vector<Sample> tradeoff_samples(const TradeoffFile& tradeoff, const fs::path& folder) {
  std::vector<Sample> samples;
  for (const TradeoffCase& c : tradeoff.cases)
    for (const TradeoffArm& arm : c.arms) {
      Case changed = arm.c;
      for (int k = 0; k < c.samples; ++k, ++changed.mixture.seed) {
        Sample sample = sample_of(changed, {}, folder);
        sample.values = {c.name, arm.name};
        sample.folder = folder / "samples" / c.name / arm.name / std::to_string(changed.mixture.seed);
        samples.push_back(std::move(sample));
      }
    }
  return samples;
}

namespace {

/// Removes the parts whose name is not in `names`, unless `names` is empty.
template <class Part, class Keep>
void select(std::vector<Part>& parts, const std::vector<std::string>& names, Keep&& keep) {
  if (names.empty()) return;
  std::erase_if(parts, [&](const Part& part) {
    return std::find(names.begin(), names.end(), part.name) == names.end() && !keep(part);
  });
}

/// Refuses an unknown name, which would select nothing without a message.
void require_known(const char* option, const std::vector<std::string>& names,
                   const std::set<std::string>& known) {
  for (const std::string& name : names)
    if (!known.contains(name))
      throw InputError(
          fmt::format("{} {}: there is no such name; allowed: {}", option, name, fmt::join(known, ", ")));
}

void select(TradeoffFile& file, const TradeoffOrder& order) {
  std::set<std::string> cases, arms;
  for (const TradeoffCase& c : file.cases) {
    cases.insert(c.name);
    for (const TradeoffArm& arm : c.arms) arms.insert(arm.name);
  }
  require_known("--cases", order.cases, cases);
  require_known("--arms", order.arms, arms);
  select(file.cases, order.cases, [](const TradeoffCase&) { return false; });
  for (TradeoffCase& c : file.cases) {
    select(c.arms, order.arms, [&](const TradeoffArm& arm) { return arm.name == c.reference; });
    if (order.samples > 0) c.samples = order.samples;
  }
}

}  // namespace

ExitCode run_tradeoff(const TradeoffOrder& order, Console console) {
  TradeoffFile file = read_tradeoff(order.file);
  select(file, order);
  if (!Checkpoints::none(order.folder))
    throw InputError(
        fmt::format("--out {} is the folder of a run; allowed: a new folder, or that of a tradeoff",
                    order.folder.string()));
  make_folder(order.folder);
  const FolderLock lock(order.folder);
  return Tradeoff(std::move(file), order, console).go();
}

}  // namespace furnas
