#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "engine/events/at_rest.h"
#include "io/case.h"
#include "io/checkpoint.h"
#include "io/frames_pvd.h"
#include "io/history.h"

namespace furnas {

/// Adds a row to history.csv every so many steps.
class RecordHistory final : public Event {
 public:
  RecordHistory(const std::filesystem::path& folder, std::int64_t step, std::int64_t period)
      : history_(folder / "history.csv", step), period_(period) {}
  const char* name() const override { return "history"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, period_); }
  std::optional<Verdict> fire(Observation& now) override {
    history_.add(now.measures());
    return {};
  }

 private:
  History history_;
  std::int64_t period_;
};

/// Writes a frame for ParaView every so many steps and keeps frames.pvd in step.
class RecordFrame final : public Event {
 public:
  RecordFrame(std::filesystem::path folder, double time, std::int64_t period);
  const char* name() const override { return "frame"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, period_); }
  std::optional<Verdict> fire(Observation& now) override;

 private:
  std::filesystem::path folder_;
  std::int64_t period_;
  std::vector<SavedFrame> frames_;
};

/// The two checkpoints of a run, written in turn, so that one good one always stays.
class Checkpoints {
 public:
  /// Begins with the older one of those that `folder` has.
  explicit Checkpoints(std::filesystem::path folder);

  /// Whether there is none yet.
  bool none() const;

  /// Writes over the older one.
  void write(const Packing& packing, const std::string& case_text, const std::vector<RestingState>& reached,
             const RestWatch& watch);

  /// The newer of those that can be read; throws InputError naming both faults when none can.
  static Checkpoint read_newest(const std::filesystem::path& folder);

 private:
  std::filesystem::path folder_;
  bool second_ = false;
};

/// The pressures at which a checkpointed run had come to rest.
std::vector<RestingState> resting_states_of(const Checkpoint& checkpoint);

/// The looks of the last window of a checkpointed run.
std::deque<RestWatch::Look> window_of(const Checkpoint& checkpoint);

/// Saves a checkpoint every so many minutes, and when asked to; a state that has diverged it refuses, so that
/// the last good one stays, and ends the run.
class SaveCheckpoint final : public Event {
 public:
  SaveCheckpoint(Checkpoints& checkpoints, std::string case_text, const std::vector<RestingState>& reached,
                 const RestWatch& watch, double minutes, std::atomic<bool>& asked);
  const char* name() const override { return "checkpoint"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 100); }
  bool due(Observation& now) override;
  bool heeds_attention() const override { return true; }
  std::optional<Verdict> fire(Observation& now) override;

 private:
  using Clock = std::chrono::steady_clock;
  Checkpoints& checkpoints_;
  std::string case_text_;
  const std::vector<RestingState>& reached_;
  const RestWatch& watch_;
  std::chrono::duration<double> period_;
  std::atomic<bool>& asked_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace furnas
