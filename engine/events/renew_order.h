#pragma once

#include "engine/compaction.h"

namespace furnas {

/// Sorts the particles in memory along a space-filling curve again, so that neighbours in space stay
/// neighbours in memory. The event happens at fixed steps, because the order of particles determines the
/// order of sums and with it the bits of the result. The neighbour list has no effect on the bits.
class RenewOrder final : public Event {
 public:
  explicit RenewOrder(std::int64_t period) : period_(period) {}
  const char* name() const override { return "renew the order"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, period_); }
  std::optional<Verdict> fire(Observation& now) override;

 private:
  std::int64_t period_;
};

}  // namespace furnas
