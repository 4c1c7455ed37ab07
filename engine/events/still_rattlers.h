#pragma once

#include "engine/events/at_rest.h"

namespace furnas {

/// Stops the rattlers once the backbone is nearly at rest.
///
/// No law damps the spin of a sphere about its contact normal, so with friction rattlers whirl on for ever
/// and keep knocking at a backbone that has long settled. Taking out their motion changes no position;
/// docs/decisions.md has the measurement.
class StillRattlers final : public Event {
 public:
  explicit StillRattlers(RestWatch& watch) : watch_(watch) {}
  const char* name() const override { return "still the rattlers"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.window_length()); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string memory() override { return std::to_string(count_); }
  void recall(const std::string& memory) override { count_ = recalled_count(memory); }

  /// How often it has happened since the run began.
  std::int64_t count() const { return count_; }

 private:
  RestWatch& watch_;
  std::int64_t count_ = 0;
};

}  // namespace furnas
