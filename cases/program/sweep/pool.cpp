#include "cases/program/sweep/pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <list>
#include <map>
#include <set>
#include <thread>

#include "cases/program/exit_code.h"
#include "cases/program/memory_limit.h"
#include "cases/program/preflight.h"
#include "cases/program/run/folder_lock.h"
#include "cases/program/run/recording.h"
#include "cases/program/sweep/child.h"
#include "cases/program/sweep/time_left.h"
#include "cases/program/sweep/turn_folder.h"
#include "engine/simulation.h"
#include "io/atomic_file.h"
#include "io/case_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Kind = TurnRecord::Kind;

/// Whether a child process of an ended worker of this machine is still saving.
bool is_in_use(const fs::path& folder) {
  if (!fs::is_directory(folder)) return false;
  try {
    const FolderLock lock(folder);
  } catch (const FolderInUse&) {
    return true;
  }
  return false;
}

/// The sample with the folder of a turn (cases/program/sweep/turns.h).
Sample sample_in(const TurnFolder& folder, const Sample& sample) {
  Sample there = sample;
  there.folder = folder.run();
  return there;
}

Child start(const Sample& sample, const TurnFolder& folder, int threads,
            std::optional<std::chrono::seconds> walltime) {
  std::vector<std::string> arguments;
  if (state_of(sample_in(folder, sample)) == SampleState::interrupted) {
    // Keys that may have changed in the file of the sweep.
    const Case::Stop& stop = sample.resolved_case.stop;
    arguments = {"resume",      folder.run().string(),
                 "--steps",     std::to_string(stop.steps),
                 "--phi-error", fmt::format("{}", stop.phi_error)};
  } else {
    write_file(folder.case_file(), resolved_toml(sample.resolved_case));
    arguments = {"run", folder.case_file().string(), "--out", folder.run().string()};
  }
  arguments.insert(arguments.end(), {"--threads", std::to_string(threads)});
  if (walltime) arguments.insert(arguments.end(), {"--walltime", fmt::format("{}s", walltime->count())});
  return {arguments, folder.log()};
}

struct Running {
  const Sample* sample;
  int turn;
  Child child;
  int threads;
  double head_start;         ///< done by earlier turns [particle-steps]
  double done = head_start;  ///< by all turns up to the last look [particle-steps]

  TurnFolder folder() const { return {*sample, turn}; }

  void look() {
    if (const auto step = folder().last_step()) done = static_cast<double>(*step) * sample->particles;
  }
};

class Pool {
 public:
  Pool(const std::vector<Sample>& samples, const PoolLimits& limits, const Worker& worker, Turns& turns)
      : limits_(limits), turns_(turns), watch_(worker), pause_(pause_of(worker)) {
    for (const Sample& sample : samples) {
      if (state_of(sample) == SampleState::finished)
        ++standing_.done;
      else
        waiting_.push_back(&sample);
    }
    waiting_.sort([](const Sample* a, const Sample* b) { return a->cost() > b->cost(); });
    for (const Sample* sample : waiting_) cost_ += sample->cost();
    all_ = cost_;
  }

  /// Requests running samples to save and stop, and waits for them; also after an exception in this process.
  ~Pool() {
    stopping_ = true;
    for (Running& r : running_) r.child.stop();
    while (!running_.empty()) {
      try {
        collect();
      } catch (const std::exception&) {
        // The next worker moves results that could not be moved to their final place.
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// Records the samples that have ended.
  void collect() {
    for (auto r = running_.begin(); r != running_.end();) {
      const auto code = r->child.ended();
      if (!code) {
        ++r;
        continue;
      }
      const Running ended = std::move(*r);
      r = running_.erase(r);
      next_look_ = {};
      take_note(ended, *code);
    }
  }

  /// Called from time to time, and when a sample has ended. Checks what other workers do, and starts samples
  /// as long as threads are free. A sample that needs more than is free waits, and all samples after it in
  /// the list wait too; otherwise it could wait for ever.
  void share() {
    if (Clock::now() < next_look_) return;
    next_look_ = Clock::now() + pause_;
    turns_.look();
    for (Running& r : running_) r.look();
    lives_.clear();
    drop_lost();
    elsewhere_ = 0;
    bool full = is_over() || free_threads() == 0;
    for (auto next = waiting_.begin(); next != waiting_.end();) {
      const Sample& sample = **next;
      Where where = where_is(sample, full);
      if (where == Where::free && !full) {
        full = !fits(sample);
        if (!full) where = begin(sample);
      }
      elsewhere_ += where == Where::elsewhere;
      next = where == Where::here || where == Where::ended ? waiting_.erase(next) : std::next(next);
    }
  }

  /// The reason why this worker has nothing more to do; empty while it has.
  std::optional<PoolEnd> end() const {
    if (!running_.empty()) return {};
    if (waiting_.empty()) return PoolEnd::whole;
    const bool none_free = waiting_.size() == elsewhere_;
    if (is_over()) return none_free ? PoolEnd::elsewhere : PoolEnd::out_of_time;
    if (none_free && !limits_.waits) return PoolEnd::elsewhere;
    return {};
  }

  SweepStanding standing() const {
    SweepStanding s = standing_;
    s.running = running_.size();
    s.elsewhere = elsewhere_;
    s.left = waiting_.size() - elsewhere_;
    SweepWork work{cost_, done_, {}};
    for (const Running& r : running_) work.running.push_back({r.sample->cost(), r.head_start, r.done});
    for (const RunningWork& r : work.running) s.late += r.late();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    s.seconds_left = seconds_left(work, seconds, pace_of_a_core * limits_.jobs);
    return s;
  }

 private:
  enum class Where { free, here, elsewhere, ended };

  static Clock::duration pause_of(const Worker& worker) {
    const std::chrono::duration<double> seconds = worker.takeover() / 24;
    return std::chrono::duration_cast<Clock::duration>(
        std::clamp(seconds, std::chrono::duration<double>(0.05), std::chrono::duration<double>(5)));
  }

  int threads_of(const Sample& sample) const {
    const int most = std::clamp(threads_for(static_cast<std::size_t>(sample.particles)), 1, limits_.jobs);
    if (!(all_ > 0)) return 1;
    return std::clamp(static_cast<int>(std::ceil(sample.cost() / (all_ / limits_.jobs))), 1, most);
  }

  int free_threads() const {
    int free = limits_.jobs;
    for (const Running& r : running_) free -= r.threads;
    return free;
  }

  bool fits(const Sample& sample) const {
    double memory = memory_;
    for (const Running& r : running_) memory -= r.sample->memory();
    // A sample that is too large for the machine starts when nothing else runs; its own process then refuses
    // it.
    return threads_of(sample) <= free_threads() && (sample.memory() <= memory || running_.empty());
  }

  /// Whole seconds until the deadline.
  std::optional<std::chrono::seconds> time_left() const {
    if (!limits_.deadline) return {};
    return std::chrono::floor<std::chrono::seconds>(*limits_.deadline - Clock::now());
  }

  /// Whether it is too late to begin a sample.
  bool is_over() const { return limits_.deadline && *time_left() < std::chrono::seconds(2); }

  /// The place of a sample that does not run here. A busy worker (`full`) does not check for samples of lost
  /// workers, but leaves them to others.
  Where where_is(const Sample& sample, bool full) {
    const std::string key = turns_.key_of(sample.folder);
    const TurnRecord last = turns_.last(key);
    if (last.kind == Kind::none) return Where::free;
    if (last.kind == Kind::taken) return full || !is_gone(sample, last) ? Where::elsewhere : Where::free;
    const TurnFolder folder(sample, last.number - 1);
    if (folder.exists()) {
      // The worker that ended the turn is just moving the result to its place, or was killed while doing so.
      if (unplaced_.insert(fmt::format("{}.{}", key, last.number)).second) return Where::elsewhere;
      folder.publish();
    }
    if (last.kind == Kind::left) return Where::free;
    // A sample that failed before this call of the program is tried once more.
    if (turns_.is_old(key) && state_of(sample) != SampleState::finished) return Where::free;
    count_as_done(sample, last.code);
    return Where::ended;
  }

  bool is_gone(const Sample& sample, const TurnRecord& taken) {
    auto [life, fresh] = lives_.try_emplace(taken.worker);
    if (fresh) life->second = watch_.life_of(taken.worker);
    if (life->second == Life::ended) return !is_in_use(TurnFolder(sample, taken.number).run());
    return life->second == Life::silent;
  }

  /// Ends the processes of samples that others took over while this worker seemed lost.
  void drop_lost() {
    for (auto r = running_.begin(); r != running_.end();) {
      if (!turns_.lost(turns_.key_of(r->sample->folder), r->turn)) {
        ++r;
        continue;
      }
      r->child.kill();
      waiting_.push_back(r->sample);
      r = running_.erase(r);
    }
  }

  /// Begins a turn at a sample and starts it, unless another worker is first.
  Where begin(const Sample& sample) {
    const std::string key = turns_.key_of(sample.folder);
    const int threads = threads_of(sample);
    fs::create_directories(sample.folder.parent_path());
    const auto turn = turns_.take(key);
    if (!turn) return Where::elsewhere;
    const TurnFolder folder(sample, *turn);
    try {
      folder.make();
      bool finished = state_of(sample) == SampleState::finished;
      if (!finished) {
        folder.fill();
        finished = state_of(sample_in(folder, sample)) == SampleState::finished;
      }
      // Finished by a worker that was killed before it recorded this, or whose record this worker could not
      // see.
      if (finished) {
        if (turns_.end(key, *turn, Kind::done)) folder.publish();
        count_as_done(sample, 0);
        return Where::ended;
      }
      const double head_start =
          static_cast<double>(Checkpoints::newest_step(folder.run()).value_or(0)) * sample.particles;
      running_.push_back({&sample, *turn, start(sample, folder, threads, time_left()), threads, head_start});
    } catch (...) {
      if (turns_.end(key, *turn, Kind::left)) folder.publish();
      throw;
    }
    return Where::here;
  }

  void take_note(const Running& ended, int code) {
    const Sample& sample = *ended.sample;
    const TurnFolder folder = ended.folder();
    // A process that SIGTERM ended while starting has nothing to save, and its sample has not failed.
    const bool asked = stopping_ && code == -SIGTERM;
    if (code < 0 && !asked)
      std::ofstream(folder.log(), std::ios::app)
          << fmt::format("\nfurnas: signal {} has ended the process\n", -code);
    const bool out_of_time = code == static_cast<int>(ExitCode::budget_spent) &&
                             state_of(sample_in(folder, sample)) != SampleState::finished;
    const bool saved = asked || out_of_time || code == static_cast<int>(ExitCode::interrupted);
    const bool ours =
        turns_.end(turns_.key_of(sample.folder), ended.turn, saved ? Kind::left : Kind::done, code);
    if (ours) folder.publish();
    if (!ours || out_of_time) {
      waiting_.push_back(&sample);
    } else {
      done_ += RunningWork{sample.cost(), ended.head_start, sample.cost()}.in_this_turn();
      count_as_done(sample, code);
    }
  }

  void count_as_done(const Sample& sample, int code) {
    cost_ -= sample.cost();
    ++standing_.done;
    if (code != static_cast<int>(ExitCode::done)) ++standing_.failed;
  }

  const PoolLimits limits_;
  const double memory_ = memory_limit().bytes;
  Turns& turns_;
  Watch watch_;
  const Clock::duration pause_;  ///< between two checks of other workers
  Clock::time_point next_look_{};
  std::map<std::string, Life> lives_;  ///< of other workers at the last check
  std::set<std::string> unplaced_;     ///< ended turns whose results were not yet in place
  std::list<const Sample*> waiting_;   ///< samples not run here: free, or run by another worker
  std::size_t elsewhere_ = 0;
  std::list<Running> running_;
  SweepStanding standing_;
  bool stopping_ = false;
  double done_ = 0;  ///< at samples that have ended here, by their cost [particle-steps]
  double cost_ = 0,
         all_ = 0;  ///< cost of the samples not done now, and not done at the start [particle-steps]
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

PoolEnd run_samples(const std::vector<Sample>& samples, const PoolLimits& limits, const Worker& worker,
                    Turns& turns, Requests& requests, const std::function<void(const SweepStanding&)>& tell) {
  Pool pool(samples, limits, worker, turns);
  for (;;) {
    if (requests.stop) return PoolEnd::stopped;
    pool.collect();
    pool.share();
    tell(pool.standing());
    if (const auto end = pool.end()) return *end;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace furnas
