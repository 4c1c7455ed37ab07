#include "cases/program/run/schedule.h"

#include "cases/program/run/progress.h"
#include "engine/events/flip.h"
#include "engine/events/limits.h"
#include "engine/events/monitor.h"
#include "engine/events/quench.h"
#include "engine/events/renew_order.h"

namespace furnas {
namespace {

constexpr std::int64_t order_period = 10'000;

/// Ends the run before the deadline, as early as saving it takes.
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
  /// A hundredth of the time, but not more than ten seconds, for a machine that is busy at the wrong moment.
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

std::vector<double> later_pressures(const Case& c, const RunContext& run) {
  return {c.compaction.pressure.begin() + 1 + static_cast<std::ptrdiff_t>(run.reached.size()),
          c.compaction.pressure.end()};
}

}  // namespace

Events schedule(RunContext& run) {
  Events events;
  const auto add = [&](std::unique_ptr<Event> event) { events.push_back(std::move(event)); };
  const Case& c = run.resolved_case;
  const bool can_rest = c.compaction.cell != "fixed";

  add(std::make_unique<Monitor>());
  add(std::make_unique<Flip>());
  add(std::make_unique<RenewOrder>(order_period));
  add(std::make_unique<RecordHistory>(run.folder, c.output.history_every));
  if (c.output.snapshot_every > 0) add(std::make_unique<RecordFrame>(run.folder, c.output.snapshot_every));
  if (can_rest) add(std::make_unique<NextPressure>(run.watch, later_pressures(c, run), run.reached));
  if (can_rest) add(std::make_unique<AtRest>(run.watch));
  if (can_rest && c.stop.criterion == "rest") add(std::make_unique<Quench>(run.watch));
  add(std::make_unique<Progress>(run.out, run.live, run.watch, run.first_step, c.stop.steps));
  add(std::make_unique<SaveCheckpoint>(run.save, c.output.checkpoint_minutes, run.requests.save,
                                       run.requests.attention));
  add(std::make_unique<Budget>(c.stop.steps));
  if (run.deadline) add(std::make_unique<WallTime>(*run.deadline, run.checkpoints, run.requests.attention));
  add(std::make_unique<Interrupted>(run.requests.stop));
  return events;
}

}  // namespace furnas
