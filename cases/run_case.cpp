#include "cases/run_case.h"

#include <fmt/format.h>
#include <unistd.h>

#include <ostream>

#include "cases/build_info.h"
#include "cases/progress.h"
#include "cases/recording.h"
#include "cases/scenario.h"
#include "cases/schedule.h"
#include "cases/signals.h"
#include "engine/analysis/faults.h"
#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "engine/events/flip.h"
#include "engine/events/limits.h"
#include "engine/events/still_rattlers.h"
#include "engine/state/fingerprint.h"
#include "engine/state/validate.h"
#include "io/atomic_file.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/manifest.h"
#include "io/outputs.h"
#include "viz/picture.h"

namespace furnas {
namespace {

using Clock = std::chrono::steady_clock;

template <class E>
std::int64_t count_of(const Events& events) {
  for (const auto& event : events)
    if (const auto* found = dynamic_cast<const E*>(event.get())) return found->count();
  return 0;
}

std::string reason_of(Verdict verdict, const Measures& m, const RestReport& rest, const Case& c) {
  switch (verdict) {
    case Verdict::jammed:
      return rest.loosely ? "at rest within the loose limit of the force balance" : "at rest";
    case Verdict::diverged:
      break;
    case Verdict::interrupted:
      return "stopped by a signal; resume goes on";
    case Verdict::budget:
      break;
  }
  const std::string why = m.step >= c.stop.steps ? "all steps are spent" : "the wall time is spent";
  return rest.waiting_for.empty() ? why : why + "; it still waits for " + rest.waiting_for;
}

/// How a run ended, and what broke it if something did.
struct Outcome {
  Verdict verdict;
  std::string failure;
};

/// Runs to the end. Numbers that leave their range are an outcome, too, seen in a step or after it.
Outcome run_to_outcome(Observation& now, const Events& events, std::atomic<bool>& attention) {
  try {
    const Verdict verdict = compact(now, events, &attention);
    if (verdict == Verdict::diverged) return {verdict, now.fault()};
    const std::string fault = fault_of(now.packing(), now.simulation().model());
    return {fault.empty() ? verdict : Verdict::diverged, fault};
  } catch (const NumericalFailure& error) {
    return {Verdict::diverged, fmt::format("{}, at step {}", error.what(), now.step())};
  }
}

Result result_of(const Outcome& outcome, Observation& now, const Events& events, const RestWatch& watch,
                 const Case& c) {
  Result result;
  result.verdict = outcome.verdict;
  result.measures = now.measures();
  result.rest = watch.report();
  result.reason =
      outcome.failure.empty() ? reason_of(outcome.verdict, result.measures, result.rest, c) : outcome.failure;
  result.rattlers_stilled = count_of<StillRattlers>(events);
  result.flips = count_of<Flip>(events);
  result.state_hash = state_hash(now.packing());
  for (Species s : now.packing().species) ++(s == Species::large ? result.large : result.small);
  const Model& model = now.simulation().model();
  result.time_step = model.time_step;
  result.pressure = model.barostat.pressure;
  result.inertia = model.barostat.inertia;
  result.threads = now.simulation().threads();
  return result;
}

void draw(const Packing& packing, const Case& c, const std::filesystem::path& folder, Console console) {
  if (c.output.picture == "none") return;
  PictureOptions options;
  options.width = options.height = c.output.picture_size;
  options.transparent = c.output.background == "transparent";
  try {
    render_png(packing, folder / "packing.png", options);
  } catch (const std::exception& error) {
    // The numbers are safe by now; a machine without OpenGL costs the picture alone.
    console.err << "furnas: no picture: " << error.what() << '\n';
  }
}

}  // namespace

RunOrder order_to_run(const Case& c) {
  RunOrder order;
  order.resolved_case = c;
  order.start = start_of(c);
  validate(order.start);
  return order;
}

RunOrder order_to_resume(const std::filesystem::path& folder, std::span<const std::string> changes) {
  Checkpoint checkpoint = Checkpoints::read_newest(folder);
  RunOrder order;
  order.resolved_case = parse_case(checkpoint.case_text, folder.string() + " (checkpoint)", changes);
  validate(order.resolved_case);
  order.folder = folder;
  order.start = std::move(checkpoint.packing);
  order.reached = resting_states_of(checkpoint);
  order.window = window_of(checkpoint);
  return order;
}

ExitCode exit_code_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::jammed:
      return ExitCode::done;
    case Verdict::budget:
      return ExitCode::budget_spent;
    case Verdict::diverged:
      return ExitCode::numerical_failure;
    case Verdict::interrupted:
      return ExitCode::interrupted;
  }
  return ExitCode::internal_error;
}

std::string summary(const Result& r, const Case& c, const std::filesystem::path& folder) {
  const Measures& m = r.measures;
  const auto& backbone = m.backbone();
  std::string text = fmt::format("verdict   {} ({})\n", to_string(r.verdict), r.reason);
  if (r.phi_J())
    text += fmt::format("phi_J     {:.5f} at p_a = {:g}, mu = {:g}\n", *r.phi_J(), r.pressure,
                        c.contact.friction);
  else if (r.verdict == Verdict::diverged)
    text += "phi       none: the last good state is that of the checkpoint\n";
  else
    text += fmt::format("phi       {:.5f} (no phi_J: the packing is not jammed)\n", m.phi);
  text +=
      fmt::format("Z         {:.3f} with rattlers, {:.3f} in the backbone of {} particles and {} contacts\n",
                  m.coordination, backbone.coordination, backbone.backbone, backbone.contacts);
  text += fmt::format("rattlers  {} of {} large, {} of {} small (fewer than {} live contacts)\n",
                      backbone.large, r.large, backbone.small, r.small, m.backbone_threshold);
  text += fmt::format("steps     {} in {}, {:.1f} million particle-steps a second on {} thread{}\n", m.step,
                      duration_text(r.wall_seconds),
                      static_cast<double>(r.steps_here) * static_cast<double>(r.large + r.small) /
                          std::max(r.wall_seconds, 1e-9) / 1e6,
                      r.threads, r.threads == 1 ? "" : "s");
  text += fmt::format("state     {:016x}\n", r.state_hash);
  text += fmt::format("files     {}\n", folder.string());
  return text;
}

ExitCode run_case(const RunOrder& order, Console console) {
  const Case& c = order.resolved_case;
  const std::string case_text = resolved_toml(c);
  write_file(order.folder / "case.resolved.toml", case_text);

  const Packing& start = order.start;
  const int threads = c.compute.threads ? *c.compute.threads : threads_for(start.size());
  const std::unique_ptr<Simulation> simulation = make_simulation(model_of(c, start), start, threads);
  Observation now(*simulation, backbone_threshold_of(c));
  RestWatch watch(rest_criteria_of(c));
  watch.restore(order.window);
  std::vector<RestingState> reached = order.reached;
  if (!reached.empty()) simulation->set_pressure(c.compaction.pressure.at(reached.size()));
  Checkpoints checkpoints(order.folder);
  // Whatever happens, there is a good state to go back to.
  if (checkpoints.none()) checkpoints.write(now.packing(), case_text, reached, watch);
  Requests requests;
  const auto begin = Clock::now();

  RunContext context{c,          order.folder, case_text,   start.step,
                     start.time, {},           console.err, isatty(STDERR_FILENO) == 1,
                     requests,   watch,        checkpoints, reached};
  if (order.walltime) context.deadline = begin + *order.walltime;
  const Events events = schedule(context);
  const SignalGuard guard(requests);
  const Outcome outcome = run_to_outcome(now, events, requests.attention);
  for (const auto& event : events)
    if (auto* progress = dynamic_cast<Progress*>(event.get())) progress->finish();

  Result result = result_of(outcome, now, events, watch, c);
  result.steps_here = now.step() - start.step;
  result.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  result.reached = reached;
  if (outcome.verdict == Verdict::jammed)
    result.reached.push_back({result.pressure, result.measures.phi, now.step()});
  if (outcome.verdict != Verdict::diverged) checkpoints.write(now.packing(), case_text, reached, watch);
  write_outputs({c, now.packing(), result}, order.folder);
  const std::string text = summary(result, c, order.folder);
  write_file(order.folder / "log.txt", text);
  if (outcome.verdict != Verdict::diverged) draw(now.packing(), c, order.folder, console);
  const BuildInfo& build = build_info();
  write_manifest(order.folder, fmt::format("furnas {}, {}, {}", build.version, build.compiler, build.type));
  console.out << text << std::flush;
  return exit_code_of(outcome.verdict);
}

}  // namespace furnas
