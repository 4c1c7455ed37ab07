#pragma once

#include "engine/compaction.h"

namespace furnas {

/// Puts the particles in memory along a space-filling curve again, so that neighbours in space stay
/// neighbours in memory. At fixed steps, because sums follow the order in memory: it is part of the
/// result's bits, the neighbour list is not.
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
