#include "cases/program/run/run_case.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <numeric>
#include <ostream>

#include "cases/program/build_info.h"
#include "cases/program/run/onlookers.h"
#include "cases/program/run/progress.h"
#include "cases/program/run/recording.h"
#include "cases/program/run/signals.h"
#include "engine/base/require.h"
#include "engine/protocol/run.h"
#include "engine/state/fingerprint.h"
#include "engine/state/species.h"
#include "engine/state/validate.h"
#include "io/atomic_file.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/case_protocol.h"
#include "io/diameters_file.h"
#include "io/manifest.h"
#include "io/outputs.h"
#include "viz/picture.h"

namespace furnas {
namespace {

using Clock = std::chrono::steady_clock;

std::string reason_of(Verdict verdict, const Measures& m, const RestReport& rest, const Case& c) {
  switch (verdict) {
    case Verdict::jammed:
      if (c.stop.criterion == "paper")
        return "the kinetic energy is below its limit, which is the only condition of stop.criterion = paper";
      return rest.loosely ? "at rest within the loose limit of the force balance" : "at rest";
    case Verdict::settled:
      return "phi can change by less than stop.phi_error";
    case Verdict::diverged:
      break;
    case Verdict::interrupted:
      return "stopped by a signal; resume continues";
    case Verdict::budget:
      break;
  }
  const std::string why = m.step >= c.stop.steps ? "all steps are spent, resume --more N adds N"
                                                 : "the wall time is spent, resume continues";
  return rest.waiting_for.empty() ? why : why + "; the run still waits for " + rest.waiting_for;
}

void draw(const Packing& packing, const Case& c, const std::filesystem::path& folder, Console console) {
  PictureOptions options;
  options.width = options.height = c.output.picture_size;
  options.transparent = c.output.background == "transparent";
  try {
    render_picture(packing, folder / "packing.png", options);
  } catch (const std::exception& error) {
    // The numbers are written by now; without OpenGL only the picture is missing.
    console.err << "furnas: no picture: " << error.what() << '\n';
  }
}

/// The part of a run in this process, from its first step to the files of the folder.
class Run {
 public:
  Run(RunOrder order, Console console);
  ExitCode go();

 private:
  Onlookers onlookers();
  void take_up();
  Result result_of(const Outcome& outcome);
  void write_files(const Packing& packing, const Outcome& outcome, const Result& result);
  /// The checkpoint of the present state.
  CheckpointView whole();
  double wall_seconds() const;
  double cpu_seconds() const;

  RunOrder order_;
  const std::filesystem::path folder_;
  const Case& case_;
  Console console_;
  LiveLines lines_{console_.err, isatty(STDERR_FILENO) == 1};
  std::string case_text_;
  Requests requests_;
  SignalGuard guard_{requests_};
  const std::int64_t first_step_;  ///< first step of this process
  std::unique_ptr<ProtocolRun> run_;
  Checkpoints checkpoints_;
  std::optional<Verdict> ended_;
};

std::unique_ptr<ProtocolRun> protocol_run(const RunOrder& order) {
  const Protocol protocol = protocol_of(order.resolved_case);
  const auto& asked = order.resolved_case.compute.threads;
  const int threads = asked ? *asked : threads_for(order.start.size());
  if (order.checkpoint.empty()) return std::make_unique<ProtocolRun>(protocol, order.start, threads);
  return std::make_unique<ProtocolRun>(protocol, order.start, threads, order.past);
}

Run::Run(RunOrder order, Console console)
    : order_(std::move(order)),
      folder_(order_.folder->path()),
      case_(order_.resolved_case),
      console_(console),
      case_text_(resolved_toml(case_)),
      first_step_(order_.start.step),
      run_(protocol_run(order_)),
      checkpoints_(folder_, order_.checkpoint, order_.checkpoint_seconds),
      ended_(order_.past.ended) {
  order_.start = {};  // the simulation has its own copy; the memory may not be enough for both
}

Onlookers Run::onlookers() {
  RunContext context{.resolved_case = case_,
                     .folder = folder_,
                     .save = [this] { checkpoints_.write(whole()); },
                     .first_step = first_step_,
                     .deadline = {},
                     .lines = lines_,
                     .requests = requests_,
                     .watch = run_->watch(),
                     .checkpoints = checkpoints_};
  if (order_.walltime) context.deadline = order_.begin + *order_.walltime;
  return onlookers_of(context);
}

/// Prepares the files of the folder for the step at which the run begins or continues.
void Run::take_up() {
  run_->begin(onlookers());
  write_file(folder_ / "case.resolved.toml", case_text_);
  // From now on there is always a good state from which the run can be resumed.
  if (order_.checkpoint.empty()) checkpoints_.write(whole());
  order_.folder->keep();
}

double Run::wall_seconds() const {
  return order_.past.wall_seconds + std::chrono::duration<double>(Clock::now() - order_.begin).count();
}

double Run::cpu_seconds() const {
  return order_.past.cpu_seconds + static_cast<double>(std::clock() - order_.cpu_begin) / CLOCKS_PER_SEC;
}

CheckpointView Run::whole() {
  return {run_->now().packing(), case_text_,
          to_extras({run_->state(), wall_seconds(), cpu_seconds(), order_.past.listed_unit, ended_})};
}

Result Run::result_of(const Outcome& outcome) {
  Observation& now = run_->now();
  Result result;
  result.verdict = outcome.verdict;
  result.version = build_info().version;
  result.measures = now.measures();
  result.measures.rebuilds = run_->lists_built();
  result.rest = run_->watch().report();
  result.reason =
      outcome.fault.empty() ? reason_of(outcome.verdict, result.measures, result.rest, case_) : outcome.fault;
  result.phi_bound = run_->phi_bound();
  result.quenches = run_->quenches();
  result.evaluations = run_->evaluations();
  result.flips = run_->flips();
  result.state_hash = state_hash(now.packing());
  for (Species s : now.packing().species) ++(s == Species::large ? result.large : result.small);
  result.polydisperse = is_polydisperse(now.packing());
  const auto& radii = now.packing().radius;
  result.sizes = sizes_of(radii);
  result.mean_diameter =
      2 * std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
  result.listed_unit = order_.past.listed_unit;
  const Model& model = run_->simulation().model();
  result.time_step = model.time_step;
  result.pressure = model.barostat.pressure;
  result.inertia = model.barostat.inertia;
  result.threads = run_->simulation().threads();
  result.steps_here = now.step();
  result.wall_seconds = wall_seconds();
  result.cpu_seconds = cpu_seconds();
  result.reached = run_->reached(outcome.verdict);
  return result;
}

void Run::write_files(const Packing& packing, const Outcome& outcome, const Result& result) {
  constexpr std::size_t many = 100'000;  // from here on writing takes seconds
  if (packing.size() >= many) lines_.show({"writes the files of " + folder_.string()});
  write_outputs({case_, packing, result}, folder_);
  const std::string text = summary(result, case_, folder_);
  write_file(folder_ / "log.txt", text);
  lines_.clear();
  console_.out << text << std::flush;
  // A run that is stopped must end at once.
  const bool stopped = outcome.verdict == Verdict::interrupted ||
                       (outcome.verdict == Verdict::budget && result.measures.step < case_.stop.steps);
  if (outcome.verdict != Verdict::diverged && !stopped && case_.output.picture != "none") {
    lines_.show({fmt::format("draws packing.png, {0} x {0} pixels", case_.output.picture_size)});
    draw(packing, case_, folder_, console_);
  }
  lines_.clear();
  const BuildInfo& build = build_info();
  write_manifest(folder_, fmt::format("furnas {}, {}, {}", build.version, build.compiler, build.type));
}

ExitCode Run::go() {
  if (!order_.remark.empty()) console_.err << "furnas: " << order_.remark << '\n';
  if (ended_) console_.err << "the run has come to its verdict before; its files are written again\n";
  take_up();
  const Outcome end = ended_ ? Outcome{*ended_, {}} : run_->go(&requests_.attention);
  lines_.clear();
  const bool moved = order_.checkpoint.empty() || run_->now().step() > first_step_;
  if (end.verdict == Verdict::jammed || end.verdict == Verdict::settled) ended_ = end.verdict;
  if (end.is_sound && moved) checkpoints_.write(whole());
  const Result result = result_of(end);
  const Packing packing =
      run_->take_packing();  // the simulation is freed, because writing needs as much memory as it had
  write_files(packing, end, result);
  return exit_code_of(end.verdict);
}

}  // namespace

RunOrder order_to_run(const Case& c) {
  RunOrder order;
  order.resolved_case = c;
  order.start = start_of(c);
  validate(order.start, c.start.file);
  if (!c.mixture.diameters.empty()) order.past.listed_unit = read_diameters(c.mixture.diameters).unit;
  return order;
}

RunOrder order_to_resume(const std::filesystem::path& folder, std::span<const std::string> changes,
                         std::optional<std::int64_t> more) {
  RunOrder order;
  order.folder = std::make_unique<RunFolder>(RunFolder::open(folder));
  Checkpoints::Found found = Checkpoints::find_newest(folder);
  order.past = continuation_of(found.checkpoint);
  order.resolved_case = case_to_go_on_with(folder, found.checkpoint, changes);
  const double settled_within = parse_case(found.checkpoint.case_text, found.file).stop.phi_error;
  if (order.past.ended == Verdict::settled && order.resolved_case.stop.phi_error != settled_within)
    order.past.ended.reset();
  order.start = std::move(found.checkpoint.packing);
  std::int64_t& steps = order.resolved_case.stop.steps;
  if (more) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    steps = *more > most - order.start.step ? most : order.start.step + *more;
    validate(order.resolved_case);
  }
  if (steps < order.start.step)
    throw InputError(fmt::format(
        "stop.steps = {}, but {} steps are done; allowed: at least {}, or --more N for N steps more", steps,
        order.start.step, order.start.step));
  order.checkpoint = found.file;
  order.checkpoint_seconds = found.seconds;
  if (!found.fault.empty())
    order.remark = "continuing from the older checkpoint " + found.file +
                   ", because the newer one is unusable: " + found.fault;
  return order;
}

ExitCode exit_code_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::jammed:
    case Verdict::settled:
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
    text += "phi       none: the last sound state is in the checkpoint\n";
  else if (r.verdict == Verdict::settled)
    text += fmt::format(
        "phi       {:.5f} +- {:.1e}, bound on the further change (no phi_J: the packing is not at rest)\n",
        m.phi, r.phi_bound);
  else
    text += fmt::format("phi       {:.5f} (no phi_J: the packing is not jammed)\n", m.phi);
  text += fmt::format(
      "Z         {:.3f} with rattlers, {:.3f} in the backbone of {} particles and {} contacts (live contacts "
      "only)\n",
      m.coordination, backbone.coordination, backbone.backbone, backbone.contacts);
  text += fmt::format(
      "rattlers  {} (fewer than {} live contacts)\n",
      r.has_species()
          ? fmt::format("{} of {} large, {} of {} small", backbone.large, r.large, backbone.small, r.small)
          : fmt::format("{} of {}", backbone.large + backbone.small, r.large + r.small),
      m.backbone_threshold);
  if (r.polydisperse)
    text += fmt::format("sizes     {}, diameters from {:.4g} to {:.4g} d_s, mean {:.4g}\n", r.sizes.count,
                        r.sizes.smallest, r.sizes.largest, r.mean_diameter);
  if (r.listed_unit)
    text += fmt::format("units     1 d_s is {:g}, the smallest diameter in {}\n", *r.listed_unit,
                        c.mixture.diameters);
  text += fmt::format("cell      {} largest diameters thick{}\n", thickness_text(r.thickness()),
                      remark_on_thickness(r.thickness()));
  if (r.evaluations > 0) text += fmt::format("minimizer {} evaluations of all forces\n", r.evaluations);
  text +=
      fmt::format("steps     {} in {}, {:.1f} million particle-steps a second on {} thread{}\n", m.step,
                  duration_text(r.wall_seconds), r.pace().value_or(0), r.threads, r.threads == 1 ? "" : "s");
  text += fmt::format("state     {:016x}\n", r.state_hash);
  text += fmt::format("files     {}\n", folder.string());
  return text;
}

ExitCode run_case(RunOrder order, Console console) { return Run(std::move(order), console).go(); }

}  // namespace furnas
