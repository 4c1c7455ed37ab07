#include "cases/program/run/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "engine/base/numbers.h"

namespace furnas {
namespace {

/// Letters in a line of the terminal; a longer line would wrap and could not be overwritten.
std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// How a line begins.
constexpr std::string_view begin_of_line = "step ";

const char* word(Trend trend) {
  switch (trend) {
    case Trend::falls:
      return " falls";
    case Trend::stands:
      return " stands";
    case Trend::rises:
      return " rises";
    case Trend::unknown:
      break;
  }
  return "";
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 172800) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} d", seconds / 86400);
}

std::string left_text(const std::optional<StepsLeft>& left, double most, double rate) {
  const std::string cap = "at most " + duration_text(most / rate);
  const auto time = [&](double steps) { return duration_text(std::min(steps, most) / rate); };
  if (!left) return "time left not known yet, " + cap;
  if (left->likely >= most) return fmt::format("left {} or more, {}", time(left->low), cap);
  if (left->high >= most)
    return fmt::format("left about {} ({} or more), {}", time(left->likely), time(left->low), cap);
  return fmt::format("left about {} ({} to {}), {}", time(left->likely), time(left->low), time(left->high),
                     cap);
}

void LiveLines::show(const std::vector<std::string>& parts) {
  clear();
  constexpr const char* between = "   ";
  const std::size_t width = terminal_width() - 1;
  std::size_t used = 0;
  for (const std::string& part : parts) {
    const bool fits = used == 0 || !live_ || used + 3 + part.size() <= width;
    if (used > 0) out_ << (fits ? between : "\n");
    if (live_ && (shown_ == 0 || !fits)) ++shown_;
    used = fits && used > 0 ? used + 3 + part.size() : part.size();
    out_ << (live_ ? part.substr(0, width) : part);
  }
  out_ << (live_ ? "" : "\n") << std::flush;
}

void LiveLines::say(const std::string& line) {
  clear();
  out_ << line << '\n' << std::flush;
}

void LiveLines::clear() {
  if (shown_ > 1) out_ << "\033[" << shown_ - 1 << 'A';
  if (shown_ > 0) out_ << "\r\033[J" << std::flush;
  shown_ = 0;
}

std::optional<std::int64_t> step_of_last_line(std::string_view output) {
  const std::size_t line = output.rfind(fmt::format("\n{}", begin_of_line));
  if (line == output.npos) return {};
  const std::string_view number = output.substr(line + 1 + begin_of_line.size());
  return number_in<std::int64_t>(std::string(number.substr(0, number.find(' '))));
}

Progress::Progress(LiveLines& lines, RestWatch& watch, std::int64_t first_step, std::int64_t last_step,
                   std::atomic<bool>& attention)
    : lines_(lines),
      watch_(watch),
      first_step_(first_step),
      last_step_(last_step),
      pause_(std::chrono::milliseconds(lines.live() ? 500 : 10'000)),
      alarm_(attention) {
  alarm_.set(start_ + pause_);
}

void Progress::look(Observation& now) {
  if (now.step() % watch_.period() != 0 || now.step() == looked_) return;
  looked_ = now.step();
  const Model& model = now.simulation().model();
  if (!forecast_) forecast_.emplace(watch_.criteria(), watch_.window_length(), !has_friction(model.law));
  if (model.barostat.pressure != pressure_) {
    forecast_->clear();
    if (pressure_ > 0)
      lines_.say(fmt::format("p_a is {:g} after {:g}, from step {} on; phi {:.5f}", model.barostat.pressure,
                             pressure_, now.step(), now.measures().phi));
  }
  pressure_ = model.barostat.pressure;
  if (model.barostat.freedom != CellFreedom::fixed) forecast_->add(now.step(), watch_.report());
}

bool Progress::due(Observation& now) {
  look(now);
  const bool has_news = now.step() == looked_ || now.evaluations() > evaluations_;
  return has_news && now.step() > first_step_ && Clock::now() - shown_ >= pause_;
}

std::string Progress::state(Observation& now, double seconds) const {
  const Measures& m = now.measures();
  const Model& model = now.simulation().model();
  const double rate = static_cast<double>(m.step - first_step_) / seconds;
  std::string text = fmt::format("{}{}  phi {:.5f}  ", begin_of_line, m.step, m.phi);
  if (model.barostat.freedom == CellFreedom::fixed)
    text += fmt::format("p {:.3e}  ", m.pressure);
  else
    text += fmt::format("p/p_a {:.4f}  ", m.pressure / model.barostat.pressure);
  text += fmt::format("{:.1f} Mps  ", rate * static_cast<double>(now.packing().size()) / 1e6);
  return text + left_text(forecast_ ? forecast_->left() : std::nullopt,
                          static_cast<double>(last_step_ - m.step), rate);
}

/// Each criterion of rest, with its limit; after a look.
std::vector<std::string> Progress::criteria() const {
  const RestReport& report = watch_.report();
  const RestCriteria& limits = watch_.criteria();
  struct Criterion {
    const char* name;
    double value, limit;
  };
  const std::array<Criterion, Forecast::criteria> all{
      {{"stress", report.stress_error, limits.stress_error},
       {"balance", report.force_imbalance, limits.force_imbalance},
       {"energy", report.kinetic_energy, limits.kinetic_energy},
       {"drift", report.strain_drift, limits.strain_drift}}};
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& [name, value, limit] = all[k];
    if (!std::isfinite(value) || (limits.kinetic_energy_alone && k != 2)) continue;
    const bool of_the_backbone = k == 1 || k == 2;
    if (of_the_backbone && report.backbone == 0) continue;
    const std::string text = fmt::format("{} {:.1e}", name, value);
    texts.push_back(value < limit
                        ? fmt::format("{} within {:.0e}", text, limit)
                        : fmt::format("{}{}, needs {:.0e}", text, word(forecast_->trend(k)), limit));
  }
  if (report.backbone == 0) texts.emplace_back("no backbone yet");
  if (report.waiting_for == "the window") texts.emplace_back("all must stay so for a window of time");
  return texts;
}

std::optional<Verdict> Progress::fire(Observation& now) {
  const Clock::time_point begin = Clock::now();
  if (!explained_)
    lines_.say("Mps: million particle-steps a second; time left: from the trends of the criteria of rest");
  explained_ = true;
  std::vector<std::string> parts{state(now, std::chrono::duration<double>(begin - start_).count())};
  if (const auto more = now.evaluations() - evaluations_; more > 0)
    parts.push_back(fmt::format("minimizing: {} evaluations since the last line", more));
  evaluations_ = now.evaluations();
  if (now.step() == looked_)
    for (std::string& criterion : criteria()) parts.push_back(std::move(criterion));
  lines_.show(parts);
  shown_ = Clock::now();
  pause_ = std::max(pause_, 20 * (shown_ - begin));
  alarm_.set(shown_ + pause_);
  return {};
}

}  // namespace furnas
