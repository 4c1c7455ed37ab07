#include "cases/recording.h"

#include <fmt/format.h>

#include <sstream>

#include "engine/analysis/faults.h"
#include "engine/base/require.h"
#include "io/vtk_xml.h"

namespace furnas {
namespace {

constexpr const char* checkpoint_names[] = {"a.checkpoint", "b.checkpoint"};
constexpr const char* resting_states_key = "resting states: pressure phi step";
constexpr const char* window_key = "window of rest: step xx yy zz yz xz xy holds holds_loosely";

std::string rows_of(const std::vector<RestingState>& reached) {
  std::string rows;
  for (const RestingState& s : reached) rows += fmt::format("{} {} {}\n", s.pressure, s.phi, s.step);
  return rows;
}

std::string rows_of(const std::deque<RestWatch::Look>& window) {
  std::string rows;
  for (const auto& [step, h, holds, loosely] : window)
    rows += fmt::format("{} {} {} {} {} {} {} {:d} {:d}\n", step, h.xx, h.yy, h.zz, h.yz, h.xz, h.xy, holds,
                        loosely);
  return rows;
}

/// What a checkpoint has under a key; empty if it is older than the key.
std::istringstream extra(const Checkpoint& checkpoint, const char* key) {
  const auto found = checkpoint.extras.find(key);
  return std::istringstream(found == checkpoint.extras.end() ? std::string() : found->second);
}

}  // namespace

RecordFrame::RecordFrame(std::filesystem::path folder, double time, std::int64_t period)
    : folder_(std::move(folder)), period_(period) {
  const auto collection = folder_ / "frames.pvd";
  if (time > 0 && std::filesystem::exists(collection)) frames_ = read_frames(collection);
  while (!frames_.empty() && frames_.back().time > time) frames_.pop_back();
}

std::optional<Verdict> RecordFrame::fire(Observation& now) {
  const std::string file = frame_file(frames_.size());
  std::filesystem::create_directories((folder_ / file).parent_path());
  write_vtp(now.packing(), folder_ / file);
  frames_.push_back({now.packing().time, file});
  write_frames(frames_, folder_ / "frames.pvd");
  return {};
}

Checkpoints::Checkpoints(std::filesystem::path folder) : folder_(std::move(folder)) {
  const auto written = [&](const char* name) {
    std::error_code missing;
    return std::filesystem::last_write_time(folder_ / name, missing);  // the least time if it is missing
  };
  second_ = written(checkpoint_names[1]) < written(checkpoint_names[0]);
}

bool Checkpoints::none() const {
  return !std::filesystem::exists(folder_ / checkpoint_names[0]) &&
         !std::filesystem::exists(folder_ / checkpoint_names[1]);
}

void Checkpoints::write(const Packing& packing, const std::string& case_text,
                        const std::vector<RestingState>& reached, const RestWatch& watch) {
  write_checkpoint(
      {packing, case_text, {{resting_states_key, rows_of(reached)}, {window_key, rows_of(watch.window())}}},
      folder_ / checkpoint_names[second_]);
  second_ = !second_;
}

Checkpoint Checkpoints::read_newest(const std::filesystem::path& folder) {
  std::optional<Checkpoint> newest;
  std::string faults;
  for (const char* name : checkpoint_names) {
    if (!std::filesystem::exists(folder / name)) continue;
    try {
      Checkpoint found = read_checkpoint(folder / name);
      if (!newest || found.packing.step > newest->packing.step) newest = std::move(found);
    } catch (const InputError& error) {
      faults += (faults.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  if (newest) return *newest;
  throw InputError(faults.empty() ? folder.string() + " holds no checkpoint; allowed: the folder of a run"
                                  : faults);
}

std::vector<RestingState> resting_states_of(const Checkpoint& checkpoint) {
  std::vector<RestingState> reached;
  std::istringstream rows = extra(checkpoint, resting_states_key);
  for (RestingState s; rows >> s.pressure >> s.phi >> s.step;) reached.push_back(s);
  return reached;
}

std::deque<RestWatch::Look> window_of(const Checkpoint& checkpoint) {
  std::deque<RestWatch::Look> window;
  std::istringstream rows = extra(checkpoint, window_key);
  RestWatch::Look look;
  Triangle& h = look.edges;
  while (rows >> look.step >> h.xx >> h.yy >> h.zz >> h.yz >> h.xz >> h.xy >> look.holds >>
         look.holds_loosely)
    window.push_back(look);
  return window;
}

SaveCheckpoint::SaveCheckpoint(Checkpoints& checkpoints, std::string case_text,
                               const std::vector<RestingState>& reached, const RestWatch& watch,
                               double minutes, std::atomic<bool>& asked)
    : checkpoints_(checkpoints),
      case_text_(std::move(case_text)),
      reached_(reached),
      watch_(watch),
      period_(std::chrono::duration<double, std::ratio<60>>(minutes)),
      asked_(asked) {}

bool SaveCheckpoint::due(Observation&) { return asked_ || Clock::now() - last_ >= period_; }

std::optional<Verdict> SaveCheckpoint::fire(Observation& now) {
  asked_ = false;
  if (std::string fault = fault_of(now.packing(), now.simulation().model()); !fault.empty())
    return now.diverged(std::move(fault));
  checkpoints_.write(now.packing(), case_text_, reached_, watch_);
  last_ = Clock::now();
  return {};
}

}  // namespace furnas
