#include "cases/program/run/progress.h"

#include <fmt/format.h>

#include <ostream>

namespace furnas {

std::string duration_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 172800) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} d", seconds / 86400);
}

Progress::Progress(std::ostream& out, bool live, RestWatch& watch, std::int64_t first_step,
                   std::int64_t last_step)
    : out_(out), live_(live), watch_(watch), first_step_(first_step), last_step_(last_step) {}

bool Progress::due(Observation&) {
  const double seconds = std::chrono::duration<double>(Clock::now() - shown_).count();
  return seconds >= (live_ ? 0.5 : 10.0);
}

std::string Progress::line(Observation& now) const {
  const Measures& m = now.measures();
  const Model& model = now.simulation().model();
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const auto steps = static_cast<double>(m.step - first_step_);
  const double rate = steps / seconds;
  std::string text = fmt::format("step {}  phi {:.5f}  ", m.step, m.phi);
  if (model.barostat.freedom == CellFreedom::fixed)
    text += fmt::format("p {:.3e}  ", m.pressure);
  else
    text += fmt::format("p/p_a {:.4f}  ", m.pressure / model.barostat.pressure);
  text += fmt::format("KE {:.1e}  ", m.kinetic_energy);
  const RestReport& rest = watch_.report();
  if (std::isfinite(rest.strain_drift)) text += fmt::format("drift {:.1e}  ", rest.strain_drift);
  if (!rest.waiting_for.empty()) text += fmt::format("waits for {}  ", rest.waiting_for);
  text += fmt::format("{:.1f} Mps  ", rate * static_cast<double>(now.packing().size()) / 1e6);
  text += fmt::format("at most {} left", duration_text(static_cast<double>(last_step_ - m.step) / rate));
  return text;
}

std::optional<Verdict> Progress::fire(Observation& now) {
  shown_ = Clock::now();
  if (live_) {
    out_ << '\r' << line(now) << "\033[K" << std::flush;
    on_line_ = true;
  } else {
    out_ << line(now) << '\n' << std::flush;
  }
  return {};
}

void Progress::finish() {
  if (on_line_) out_ << "\r\033[K" << std::flush;
  on_line_ = false;
}

}  // namespace furnas
