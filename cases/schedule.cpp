#include "cases/schedule.h"

#include "cases/progress.h"
#include "engine/events/flip.h"
#include "engine/events/limits.h"
#include "engine/events/monitor.h"
#include "engine/events/renew_order.h"
#include "engine/events/still_rattlers.h"

namespace furnas {
namespace {

constexpr std::int64_t order_period = 10'000;

/// Turns the deadline into a request to stop.
class WallTime final : public Event {
 public:
  explicit WallTime(std::chrono::steady_clock::time_point deadline) : deadline_(deadline) {}
  const char* name() const override { return "wall time"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 100); }
  bool due(Observation&) override { return std::chrono::steady_clock::now() >= deadline_; }
  std::optional<Verdict> fire(Observation&) override { return Verdict::budget; }

 private:
  std::chrono::steady_clock::time_point deadline_;
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
  add(std::make_unique<RecordHistory>(run.folder, run.first_step, c.output.history_every));
  if (c.output.snapshot_every > 0)
    add(std::make_unique<RecordFrame>(run.folder, run.first_time, c.output.snapshot_every));
  if (can_rest) add(std::make_unique<NextPressure>(run.watch, later_pressures(c, run), run.reached));
  if (can_rest) add(std::make_unique<AtRest>(run.watch));
  if (can_rest && c.stop.criterion == "rest") add(std::make_unique<StillRattlers>(run.watch));
  add(std::make_unique<Progress>(run.out, run.live, run.watch, run.first_step, c.stop.steps));
  add(std::make_unique<SaveCheckpoint>(run.checkpoints, run.case_text, run.reached, run.watch,
                                       c.output.checkpoint_minutes, run.requests.save));
  add(std::make_unique<Budget>(c.stop.steps));
  if (run.deadline) add(std::make_unique<WallTime>(*run.deadline));
  add(std::make_unique<Interrupted>(run.requests.stop));
  return events;
}

}  // namespace furnas
