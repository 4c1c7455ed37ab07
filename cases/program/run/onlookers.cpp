#include "cases/program/run/onlookers.h"

#include "engine/events/limits.h"

namespace furnas {
namespace {

/// Ends the run before the deadline, early enough to save a checkpoint.
class WallTime final : public Event {
 public:
  using Clock = std::chrono::steady_clock;

  WallTime(Clock::time_point deadline, const Checkpoints& checkpoints, std::atomic<bool>& attention)
      : deadline_(deadline),
        spare_(spare_of(deadline - Clock::now())),
        checkpoints_(checkpoints),
        alarm_(attention) {
    alarm_.set(end_ = latest_end());
  }
  const char* name() const override { return "wall time"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 100); }
  bool due(Observation&) override {
    if (const auto end = latest_end(); end != end_) alarm_.set(end_ = end);
    return Clock::now() >= end_;
  }
  bool heeds_attention() const override { return true; }
  std::optional<Verdict> fire(Observation&) override { return Verdict::budget; }

 private:
  /// Spare time for a busy machine: a hundredth of the wall time, but at most ten seconds.
  static Clock::duration spare_of(Clock::duration whole) {
    return std::min<Clock::duration>(whole / 100, std::chrono::seconds(10));
  }

  /// Twice what the slowest checkpoint took, because the next one may be slower.
  Clock::time_point latest_end() const {
    return deadline_ - spare_ - std::chrono::duration_cast<Clock::duration>(2 * checkpoints_.longest());
  }

  Clock::time_point deadline_, end_;
  Clock::duration spare_;
  const Checkpoints& checkpoints_;
  Alarm alarm_;
};

}  // namespace

Onlookers onlookers_of(RunContext& run) {
  const Case& c = run.resolved_case;
  Onlookers o;
  o.before_verdict.push_back(std::make_unique<RecordHistory>(run.folder, c.output.history_every));
  if (c.output.snapshot_every > 0 || c.output.snapshot_phi > 0)
    o.before_verdict.push_back(std::make_unique<RecordFrame>(
        run.folder, FrameRhythm{c.output.snapshot_every, c.output.snapshot_phi}));
  o.after_verdict.push_back(
      std::make_unique<Progress>(run.lines, run.watch, run.first_step, c.stop.steps, run.requests.attention));
  o.after_verdict.push_back(std::make_unique<SaveCheckpoint>(run.save, c.output.checkpoint_minutes,
                                                             run.requests.save, run.requests.attention));
  if (run.deadline)
    o.limits.push_back(std::make_unique<WallTime>(*run.deadline, run.checkpoints, run.requests.attention));
  o.limits.push_back(std::make_unique<Interrupted>(run.requests.stop));
  return o;
}

}  // namespace furnas
