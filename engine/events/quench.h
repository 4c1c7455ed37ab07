#pragma once

#include "engine/events/at_rest.h"

namespace furnas {

/// Takes out all motion, of the particles and of the cell, once the packing is nearly at rest.
///
/// What still moves then is what no law damps: a sphere that spins about its contact normal, rattlers that
/// knock at a backbone long settled, a cell that shears to and fro while contacts see peculiar velocities
/// alone. It changes no position and no force, only the time until they balance; docs/decisions.md has the
/// measurement.
class Quench final : public Event {
 public:
  explicit Quench(RestWatch& watch) : watch_(watch) {}
  const char* name() const override { return "quench"; }
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
