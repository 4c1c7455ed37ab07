#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

#include "engine/events/at_rest.h"

namespace furnas {

/// Shows how a run goes on: one line that is renewed on a terminal, plain lines elsewhere.
class Progress final : public Event {
 public:
  /// `last_step` is where the budget ends; `live` means a terminal.
  Progress(std::ostream& out, bool live, RestWatch& watch, std::int64_t first_step, std::int64_t last_step);
  const char* name() const override { return "progress"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 1000); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  /// Ends the live line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(Observation& now) const;

  std::ostream& out_;
  bool live_;
  RestWatch& watch_;
  std::int64_t first_step_;
  std::int64_t last_step_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  bool on_line_ = false;
};

/// "3 s", "12 min", "2.5 h", "3.1 d".
std::string duration_text(double seconds);

}  // namespace furnas
