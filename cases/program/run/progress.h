#pragma once

#include <chrono>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/program/run/alarm.h"
#include "cases/program/run/forecast.h"
#include "engine/events/at_rest.h"

namespace furnas {

/// Lines that are overwritten on a terminal, and plain lines elsewhere.
class LiveLines {
 public:
  /// `live` means a terminal.
  LiveLines(std::ostream& out, bool live) : out_(out), live_(live) {}

  /// On a terminal, replaces the last lines by these; elsewhere, prints all parts as one line.
  void show(const std::vector<std::string>& parts);
  /// A line that stays.
  void say(const std::string& line);
  /// Removes the live lines.
  void clear();

  bool live() const { return live_; }

 private:
  std::ostream& out_;
  bool live_;
  std::size_t shown_ = 0;  ///< lines on the terminal now
};

/// The step of the last line of Progress in an output that is no terminal; empty before the first line.
std::optional<std::int64_t> step_of_last_line(std::string_view output);

/// Shows the progress of a run: its state, the estimated time left, and the criteria of rest with their
/// limits. A line appears where the criteria are evaluated, and while the minimizer works, which may take
/// minutes from one such step to the next.
class Progress final : public Event {
 public:
  using Clock = std::chrono::steady_clock;

  /// The budget of steps ends at `last_step`. The event itself sets `attention` when a line is due.
  Progress(LiveLines& lines, RestWatch& watch, std::int64_t first_step, std::int64_t last_step,
           std::atomic<bool>& attention);
  const char* name() const override { return "progress"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.period()); }
  bool due(Observation& now) override;
  bool heeds_attention() const override { return true; }
  std::optional<Verdict> fire(Observation& now) override;

 private:
  /// Adds the criteria of this step to the forecast; once a period, at steps that no clock determines.
  void look(Observation& now);
  std::string state(Observation& now, double seconds) const;
  std::vector<std::string> criteria() const;

  LiveLines& lines_;
  RestWatch& watch_;
  std::int64_t first_step_;
  std::int64_t last_step_;
  std::optional<Forecast> forecast_;
  double pressure_ = 0;           ///< of the bath at the last look
  std::int64_t looked_ = -1;      ///< the last step in the forecast
  std::int64_t evaluations_ = 0;  ///< by the minimizer, at the last line
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  Clock::duration pause_;  ///< between two lines; long enough that lines take a twentieth of the time
  bool explained_ = false;
  Alarm alarm_;
};

/// "3 s", "12 min", "2.5 h", "3.1 d".
std::string duration_text(double seconds);

/// A forecast in words, at `rate` steps per second and with `most` steps left in the budget: "left about 12 s
/// (6 s to 30 s), at most 40 min".
std::string left_text(const std::optional<StepsLeft>& left, double most, double rate);

}  // namespace furnas
