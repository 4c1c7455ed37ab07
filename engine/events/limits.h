#pragma once

#include <algorithm>
#include <atomic>

#include "engine/compaction.h"

namespace furnas {

/// Ends the run at its last allowed step.
class Budget final : public Event {
 public:
  explicit Budget(std::int64_t last_step) : last_step_(last_step) {}
  const char* name() const override { return "budget"; }
  std::int64_t next(std::int64_t step) const override { return std::max(step, last_step_); }
  std::optional<Verdict> fire(Observation&) override { return Verdict::budget; }

 private:
  std::int64_t last_step_;
};

/// Ends the run when a signal or a limit on the wall time has set `stop`.
class Interrupted final : public Event {
 public:
  explicit Interrupted(const std::atomic<bool>& stop) : stop_(stop) {}
  const char* name() const override { return "interrupted"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 1000); }
  bool due(Observation&) override { return stop_; }
  bool heeds_attention() const override { return true; }
  std::optional<Verdict> fire(Observation&) override { return Verdict::interrupted; }

 private:
  const std::atomic<bool>& stop_;
};

}  // namespace furnas
