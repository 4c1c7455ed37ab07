#include "cases/recording.h"

#include <fmt/format.h>

#include <sstream>

#include "engine/base/require.h"
#include "io/vtk_xml.h"

namespace furnas {
namespace {

constexpr const char* checkpoint_names[] = {"a.checkpoint", "b.checkpoint"};
constexpr const char* resting_states_key = "resting states: pressure phi step";

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

void Checkpoints::write(const Packing& packing, const std::string& case_text,
                        const std::vector<RestingState>& reached) {
  std::string rows;
  for (const RestingState& s : reached) rows += fmt::format("{} {} {}\n", s.pressure, s.phi, s.step);
  write_checkpoint({packing, case_text, {{resting_states_key, rows}}}, folder_ / checkpoint_names[second_]);
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
  const auto found = checkpoint.extras.find(resting_states_key);
  if (found == checkpoint.extras.end()) return reached;
  std::istringstream rows(found->second);
  for (RestingState s; rows >> s.pressure >> s.phi >> s.step;) reached.push_back(s);
  return reached;
}

SaveCheckpoint::SaveCheckpoint(Checkpoints& checkpoints, std::string case_text,
                               const std::vector<RestingState>& reached, double minutes,
                               std::atomic<bool>& asked)
    : checkpoints_(checkpoints),
      case_text_(std::move(case_text)),
      reached_(reached),
      period_(std::chrono::duration<double, std::ratio<60>>(minutes)),
      asked_(asked) {}

bool SaveCheckpoint::due(Observation&) { return asked_ || Clock::now() - last_ >= period_; }

std::optional<Verdict> SaveCheckpoint::fire(Observation& now) {
  asked_ = false;
  checkpoints_.write(now.packing(), case_text_, reached_);
  last_ = Clock::now();
  return {};
}

}  // namespace furnas
