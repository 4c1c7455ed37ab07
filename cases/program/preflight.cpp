#include "cases/program/preflight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/program/census.h"
#include "cases/program/expected_steps.h"
#include "cases/program/run/progress.h"
#include "engine/base/sphere.h"
#include "engine/monitor/stability.h"
#include "engine/protocol/protocol.h"
#include "engine/simulation.h"
#include "io/case_protocol.h"
#include "io/diameters_file.h"
#include "io/result.h"

namespace furnas {
namespace {

/// The largest whole number below `tried` that fits; 0 if none does.
template <class Fits>
std::int64_t largest_below(std::int64_t tried, Fits&& fits) {
  std::int64_t low = 0;
  for (std::int64_t high = tried; high - low > 1;) {
    const std::int64_t middle = low + (high - low) / 2;
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

/// A suggestion that would fit into the memory.
std::string smaller(double particles, const MemoryLimit& limit, const Case& c) {
  Case changed = c;
  changed.output.picture = "none";
  if (expected_memory(particles, changed) <= limit.bytes) {
    changed.output.picture = c.output.picture;
    const std::int64_t size = largest_below(c.output.picture_size, [&](std::int64_t edge) {
      changed.output.picture_size = edge;
      return expected_memory(particles, changed) <= limit.bytes;
    });
    return size > 0 ? fmt::format("a smaller picture (output.picture_size = {})", size)
                    : "no picture (output.picture = \"none\")";
  }
  if (!c.start.file.empty()) return "a smaller start.file";
  if (!c.mixture.diameters.empty()) return "a shorter list of diameters";
  const std::int64_t large = largest_below(c.mixture.large, [&](std::int64_t some) {
    const double share = static_cast<double>(some) / static_cast<double>(c.mixture.large);
    return expected_memory(share * particles, c) <= limit.bytes;
  });
  return large > 0 ? fmt::format("fewer particles (mixture.large = {})", large) : "a larger machine";
}

std::string refusal_of_memory(double particles, const MemoryLimit& limit, const Case& c) {
  const double needed = expected_memory(particles, c);
  if (needed <= limit.bytes) return {};
  return fmt::format("the run needs about {:.1f} GB and {} {:.1f} GB; take {}", needed / 1e9, limit.source,
                     limit.bytes / 1e9, smaller(particles, limit, c));
}

double steps_of_window(const Case& c, double smallest) {
  return c.stop.window / relative_time_step(protocol_of(c), smallest);
}

/// Refuses a run that cannot come to rest, or only after decades.
std::string refusal_of_time(double seconds_a_step, const Case& c, double smallest) {
  if (c.compaction.cell == "fixed") return {};  // such a run is meant to end with its steps
  if (c.contact.normal_damping == 0 && c.contact.friction == 0 &&
      c.compaction.drag.value_or(c.compaction.cell_damping) == 0)
    return fmt::format(
        "nothing takes energy out: contact.normal_damping, contact.friction and compaction.{} are 0, so that "
        "the packing never comes to rest; give one of them a value, or take compaction.cell = \"fixed\"",
        c.compaction.drag ? "drag" : "cell_damping");
  constexpr double longest = 30 * 365.25 * 86400;  // [s]
  const double window = steps_of_window(c, smallest);
  const double shortest = seconds_a_step * std::min(window, static_cast<double>(c.stop.steps));
  if (shortest > longest)
    return fmt::format(
        "one window of stop.window = {} t_c takes about {:.0f} years; take a shorter window or fewer "
        "particles",
        c.stop.window, shortest / (365.25 * 86400));
  return {};
}

Touch<double> pair_of(const Census::Kind& a, const Census::Kind& b) {
  return resting_touch(a.diameter / 2, b.diameter / 2, reduced_mass(a.mass, b.mass), 0);
}

/// The pair of the two lightest spheres, which oscillates fastest.
Touch<double> lightest_pair(const Census& n) {
  const double radius = n.sizes.smallest / 2;
  return resting_touch(radius, radius, reduced_mass(n.lightest[0], n.lightest[1]), 0);
}

std::string pairs_report(const Census& n, const AnyLaw& law) {
  std::string text = "pairs\n";
  const auto line = [&](const Census::Kind& a, const Census::Kind& b) {
    const double e = restitution(law, pair_of(a, b));
    const std::string name = a.name + "-" + b.name;
    text += fmt::format("  {:<{}} restitution {}\n", name, n.polydisperse ? 17 : 12,
                        e > 0 ? fmt::format("{:.4f}", e) : "0 (overdamped)");
  };
  const Census::Kind &first = n.kinds.front(), &last = n.kinds.back();
  line(first, first);
  if (n.kinds.size() == 1) return text;
  if (last.diameter > first.diameter) line(first, last);
  line(last, last);
  return text;
}

/// Refuses a time step at which the two lightest spheres are unstable. The automatic choice and the range of
/// allowed time steps assume the density 1.
std::string refusal_of_step(const Census& n, double dt, const AnyLaw& law) {
  const double limit = largest_stable_step(law, lightest_pair(n));
  if (dt < limit) return {};
  return fmt::format(
      "the time step {:.4g} is too long for the two lightest spheres, of masses {:.4g} and {:.4g} rho d_s^3; "
      "allowed: compaction.time_step_absolute below {:.4g}",
      dt, n.lightest[0], n.lightest[1], limit);
}

/// A line with 1 d_s in the unit of the case's list of diameters; empty without a list.
std::string unit_of_list(const Case& c) {
  if (c.mixture.diameters.empty()) return {};
  return fmt::format("1 d_s is {:g}, the smallest diameter in {}", read_diameters(c.mixture.diameters).unit,
                     c.mixture.diameters);
}

/// A number with one digit: "2e5".
std::string one_digit(double x) {
  std::string text = fmt::format("{:.0e}", x);  // "2e+05"
  text.erase(text.find('e') + 1, text[text.find('e') + 2] == '0' ? 2 : 1);
  return text;
}

/// A remark on a size ratio without effect: in a mixture without small spheres all spheres are equal.
std::string remark_on_size_ratio(const Case& c) {
  if (c.mixture.size_ratio == 1 || c.mixture.small_fraction > 0) return {};
  return fmt::format(
      "mixture.size_ratio = {:g} has no effect: with mixture.small_fraction = 0 all spheres have the "
      "diameter 1",
      c.mixture.size_ratio);
}

/// A remark on a random start in a fixed cell; nothing would move there.
std::string remark_on_fixed_gas(const Case& c) {
  if (c.compaction.cell != "fixed" || !c.start.file.empty()) return {};
  return "compaction.cell = \"fixed\" keeps the random start as it is: no sphere touches another, and none "
         "moves; "
         "a fixed cell is for a packing in start.file";
}

}  // namespace

double expected_memory(double particles, const Case& c) {
  // Measured peaks, docs/results/performance.md: one while measures of the running packing are computed, one
  // while the final picture is drawn.
  constexpr double program = 36e6, renderer = 126e6, pixel = 89, drawn_particle = 420;
  // Contacts per particle of equal spheres at rest; within 0.1 of the values in docs/results/verification.md.
  const double contacts = 1.95 + 1.05 * std::exp(-c.contact.friction / 0.15);
  const double particle = (c.compute.precision == "double" ? 632 : 412) + 160 * contacts;
  const double running = program + particles * particle;
  if (c.output.picture == "none") return running;
  const double edge = c.output.picture_size;
  return std::max(running, renderer + pixel * edge * edge + particles * drawn_particle);
}

Preflight check_case(const Case& c, const MemoryLimit& limit) {
  const Census n = census_of(c);
  Preflight out;
  out.report += text_of(n);
  const AnyLaw law = law_of(protocol_of(c));
  const double smallest = n.sizes.smallest;
  const auto [dt, rule] = chosen_time_step(protocol_of(c), smallest);
  out.report += fmt::format(
      "time step {:.6g}, {:.3g} t_c ({}), {:.3f} of the stiffest pair's 1/frequency (stable below 2)\n", dt,
      relative_time_step(protocol_of(c), smallest), rule, dt * pair_frequency(law, lightest_pair(n)));
  out.report += pairs_report(n, law);
  out.refusal = refusal_of_units(n, c);
  const std::string unit = unit_of_list(c);
  std::vector<std::string> notes{remark_on_size_ratio(c), remark_on_fixed_gas(c)};
  std::erase(notes, "");
  out.remark = unit;
  for (const std::string& note : notes) out.remark += (out.remark.empty() ? "" : "; ") + note;
  for (const std::string& units : {out.refusal, unit})
    if (!units.empty()) out.report += "units     " + units + "\n";
  for (const std::string& note : notes) out.report += "note      " + note + "\n";

  const double diameters = dense_thickness(n.volume) / n.sizes.largest;
  out.report += fmt::format(
      "cell      about {} largest diameters thick when dense{}{}\n", thickness_text(diameters),
      remark_on_thickness(diameters),
      diameters < 2.1 ? ", and spheres touch several images of each other: slower, but still correct" : "");
  out.report += fmt::format("memory    about {:.2f} GB\n", expected_memory(n.particles, c) / 1e9);
  const int threads =
      c.compute.threads ? *c.compute.threads : threads_for(static_cast<std::size_t>(n.particles));
  const double rate = pace_of_a_core * threads;
  const double expected = expected_steps(c, n.particles);
  const auto seconds = [&](double steps) { return steps * n.particles / rate; };
  const bool drawn = c.start.file.empty() && c.mixture.diameters.empty();
  out.report +=
      fmt::format("time      about {} for {} steps, {}; {} for the cap of {} steps; on {} thread{}{}\n",
                  duration_text(seconds(expected)), one_digit(std::max(expected, 1.0)),
                  drawn ? "known within a factor of three" : "a guess from equal spheres",
                  duration_text(seconds(static_cast<double>(c.stop.steps))), c.stop.steps, threads,
                  threads == 1 ? "" : "s", c.output.picture == "none" ? "" : "; without the picture");

  const auto windows = static_cast<double>(c.compaction.pressure.size());
  if (c.compaction.cell != "fixed" &&
      windows * steps_of_window(c, smallest) > static_cast<double>(c.stop.steps))
    out.report += fmt::format("verdict   none: {} window{} of {} t_c do not fit into the cap of {} steps\n",
                              windows, windows == 1 ? "" : "s", c.stop.window, c.stop.steps);
  if (out.refusal.empty()) out.refusal = refusal_of_memory(n.particles, limit, c);
  if (out.refusal.empty()) out.refusal = refusal_of_step(n, dt, law);
  if (out.refusal.empty()) out.refusal = refusal_of_time(seconds(1), c, smallest);
  return out;
}

}  // namespace furnas
