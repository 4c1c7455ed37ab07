#include "cases/program/sweep/pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <list>
#include <thread>

#include "cases/program/exit_code.h"
#include "cases/program/memory_limit.h"
#include "cases/program/preflight.h"
#include "cases/program/run/folder_lock.h"
#include "cases/program/sweep/child.h"
#include "engine/simulation.h"
#include "io/atomic_file.h"
#include "io/case_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Whether a process that an earlier sweep has left still saves what it did.
bool is_in_use(const fs::path& folder) {
  if (!fs::is_directory(folder)) return false;
  try {
    const FolderLock lock(folder);
  } catch (const FolderInUse&) {
    return true;
  }
  return false;
}

Child start(const Sample& sample, int threads) {
  fs::create_directories(sample.folder.parent_path());
  std::vector<std::string> arguments;
  if (state_of(sample) == SampleState::interrupted) {
    // What may have changed in the file of the sweep.
    const Case::Stop& stop = sample.resolved_case.stop;
    arguments = {"resume",      sample.folder.string(),           "--steps", std::to_string(stop.steps),
                 "--phi-error", fmt::format("{}", stop.phi_error)};
  } else {
    // What a killed process has left before its first checkpoint.
    fs::remove_all(sample.folder);
    const std::string file = sample.folder.string() + ".toml";
    write_file(file, resolved_toml(sample.resolved_case));
    arguments = {"run", file, "--out", sample.folder.string()};
  }
  arguments.insert(arguments.end(), {"--threads", std::to_string(threads)});
  return {arguments, sample.log()};
}

struct Running {
  const Sample* sample;
  Child child;
  int threads;
  Clock::time_point since = Clock::now();

  /// What it has probably done of its cost [particle-steps].
  double progress() const {
    const double seconds = std::chrono::duration<double>(Clock::now() - since).count();
    return std::min(pace_of_a_core * threads * seconds, sample->cost());
  }
};

class Pool {
 public:
  Pool(const std::vector<Sample>& samples, int jobs) : jobs_(jobs) {
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

  /// Asks those that run to save and stop, and waits for them: also when something goes wrong here.
  ~Pool() {
    stopping_ = true;
    for (Running& r : running_) r.child.stop();
    while (!running_.empty()) {
      collect();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  bool empty() const { return waiting_.empty() && running_.empty(); }

  /// Starts the samples that there are threads for. A sample that needs more waits, and all behind it wait,
  /// too: if they went first, the large sample would wait for ever.
  void start_some() {
    int free = jobs_;
    double memory = memory_;
    for (const Running& r : running_) free -= r.threads, memory -= r.sample->memory();
    for (auto next = waiting_.begin(); next != waiting_.end();) {
      const Sample& sample = **next;
      const int threads = threads_of(sample);
      // A sample that is too large for the machine is refused when it runs alone, by itself.
      if (threads > free || (sample.memory() > memory && !running_.empty())) return;
      if (is_in_use(sample.folder)) {
        ++next;
        continue;
      }
      running_.push_back({&sample, start(sample, threads), threads});
      free -= threads, memory -= sample.memory();
      next = waiting_.erase(next);
    }
  }

  /// Takes note of those that have ended.
  void collect() {
    for (auto r = running_.begin(); r != running_.end();) {
      const auto code = r->child.ended();
      if (!code) {
        ++r;
        continue;
      }
      // A sample that was just starting has nothing to save, and has not failed.
      const bool asked = stopping_ && *code == -SIGTERM;
      if (*code < 0 && !asked)
        std::ofstream(r->sample->log(), std::ios::app)
            << fmt::format("\nfurnas: signal {} has ended the process\n", -*code);
      cost_ -= r->sample->cost();
      ++standing_.done;
      if (*code != static_cast<int>(ExitCode::done)) ++standing_.failed;
      r = running_.erase(r);
    }
  }

  SweepStanding standing() const {
    SweepStanding s = standing_;
    s.running = running_.size();
    s.left = waiting_.size();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    const double expected = pace_of_a_core * jobs_;  // particle-steps a second
    double left = cost_;
    for (const Running& r : running_) left -= r.progress();
    // The expected pace counts like a minute of measurement.
    constexpr double minute = 60;
    const double pace = (all_ - left + minute * expected) / (seconds + minute);
    s.seconds_left = left / pace;
    return s;
  }

 private:
  int threads_of(const Sample& sample) const {
    const int most = std::clamp(threads_for(static_cast<std::size_t>(sample.particles)), 1, jobs_);
    return std::clamp(static_cast<int>(std::ceil(sample.cost() / (all_ / jobs_))), 1, most);
  }

  int jobs_;
  const double memory_ = memory_limit().bytes;
  std::list<const Sample*> waiting_;
  std::list<Running> running_;
  SweepStanding standing_;
  bool stopping_ = false;
  double cost_ = 0, all_ = 0;  ///< of what is not done, and of what was not at the start [particle-steps]
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

bool run_samples(const std::vector<Sample>& samples, int jobs, Requests& requests,
                 const std::function<void(const SweepStanding&)>& tell) {
  Pool pool(samples, jobs);
  for (;;) {
    if (requests.stop) return false;
    pool.collect();
    pool.start_some();
    tell(pool.standing());
    if (pool.empty()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace furnas
