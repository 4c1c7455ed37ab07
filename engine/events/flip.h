#pragma once

#include "engine/compaction.h"

namespace furnas {

/// Replaces tilted edges of the cell by the shortest equivalent ones, once a tilt exceeds 0.55 of its edge.
/// The lattice, and so every contact, force and history, stays the same: only the numbers of the images
/// change, which are integers and therefore exact. Returns whether anything changed.
bool flip_cell(Packing& packing);

/// Checks the tilt of the cell at fixed intervals and flips the cell if needed.
class Flip final : public Event {
 public:
  explicit Flip(std::int64_t period) : period_(period) {}
  const char* name() const override { return "flip"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, period_); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override { return std::to_string(count_); }
  void restore(const std::string& saved) override { count_ = saved_count(saved); }

  /// How often the cell has been flipped since the run began.
  std::int64_t count() const { return count_; }

 private:
  std::int64_t period_;  // [steps]
  std::int64_t count_ = 0;
};

}  // namespace furnas
