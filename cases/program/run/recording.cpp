#include "cases/program/run/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "engine/base/require.h"
#include "engine/monitor/faults.h"
#include "io/atomic_file.h"
#include "io/vtp_packing.h"

namespace furnas {
namespace {

constexpr const char* checkpoint_names[] = {"a.checkpoint", "b.checkpoint"};

FileMark mark_of(const std::string& text) {
  Hasher hasher;
  hasher.add_bytes(text.data(), text.size());
  return {text.size(), hasher.value()};
}

std::chrono::duration<double> since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::steady_clock::now() - begin;
}

}  // namespace

void RecordHistory::restore(const std::string& saved) {
  saved.empty() ? history_.emplace(path_) : history_.emplace(path_, parse_mark(saved));
}

std::optional<Verdict> RecordHistory::fire(Observation& now) {
  history_->add(now.measures());
  return {};
}

std::int64_t RecordFrame::next(std::int64_t step) const {
  constexpr std::int64_t look = 10;  // steps between two checks of phi, which cost little
  if (frames_.empty() && step == 0) return step;
  if (rhythm_.steps == 0) return next_multiple(step, look);
  const std::int64_t by_steps = next_multiple(step, rhythm_.steps);
  return rhythm_.phi > 0 ? std::min(by_steps, next_multiple(step, look)) : by_steps;
}

/// The packing fraction in units of rhythm_.phi, rounded down.
std::int64_t RecordFrame::multiple_below(Observation& now) {
  constexpr double rounding = 1e-9;  // so that 0.3 is three times 0.1
  if (sphere_volume_ == 0) sphere_volume_ = now.packing().sphere_volume();
  const double phi = sphere_volume_ / now.simulation().cell().volume();
  return static_cast<std::int64_t>(std::floor(phi / rhythm_.phi + rounding));
}

bool RecordFrame::due(Observation& now) {
  if (frames_.empty()) return true;
  if (rhythm_.steps > 0 && now.step() % rhythm_.steps == 0) return true;
  return rhythm_.phi > 0 && multiple_below(now) > highest_;
}

std::string RecordFrame::saved() {
  if (frames_.empty()) return {};
  const std::string mark = to_text(mark_of(frames_text(frames_)));
  return rhythm_.phi > 0 ? fmt::format("{}\n{}", mark, highest_) : mark;
}

void RecordFrame::restore(const std::string& saved) {
  const auto collection = folder_ / "frames.pvd";
  frames_.clear();
  if (saved.empty()) {
    std::filesystem::remove(collection);
  } else {
    const std::size_t end = saved.find('\n');
    const FileMark mark = parse_mark(saved.substr(0, end));
    if (end != saved.npos) highest_ = saved_count(saved.substr(end + 1));
    frames_ = read_frames(collection);
    while (frames_text(frames_).size() > mark.bytes && !frames_.empty()) frames_.pop_back();
    const std::string text = frames_text(frames_);
    if (mark_of(text) != mark)
      throw InputError(collection.string() +
                       ": lacks frames that the run had written when it was saved; restore the file");
    write_file(collection, text);
  }
  remove_later_frames();
}

/// Removes frames after the checkpoint. The run will write most of them again, and the others would be wrong.
void RecordFrame::remove_later_frames() const {
  for (std::size_t k = frames_.size(); std::filesystem::remove(folder_ / frame_file(k));) ++k;
}

/// Makes the folder frames only, not the folders above it: a deleted folder of a run must not reappear empty.
void RecordFrame::make_frames_folder() const {
  const auto frames = (folder_ / frame_file(0)).parent_path();
  std::error_code error;
  std::filesystem::create_directory(frames, error);
  if (error) throw OutputError("cannot make the folder " + frames.string() + ": " + error.message());
}

std::optional<Verdict> RecordFrame::fire(Observation& now) {
  const std::string file = frame_file(frames_.size());
  make_frames_folder();
  write_vtp(now.packing(), folder_ / file);
  if (rhythm_.phi > 0) highest_ = std::max(highest_, multiple_below(now));
  frames_.push_back({now.packing().time, file});
  write_file(folder_ / "frames.pvd", frames_text(frames_));
  return {};
}

Checkpoints::Checkpoints(std::filesystem::path folder, const std::string& file, double seconds)
    : folder_(std::move(folder)), second_(file == checkpoint_names[0]), longest_(seconds) {}

void Checkpoints::write(const CheckpointView& checkpoint) {
  const auto begin = std::chrono::steady_clock::now();
  write_checkpoint(checkpoint, folder_ / checkpoint_names[second_]);
  second_ = !second_;
  longest_ = std::max(longest_, since(begin));
}

bool Checkpoints::none(const std::filesystem::path& folder) {
  return std::none_of(std::begin(checkpoint_names), std::end(checkpoint_names),
                      [&](const char* name) { return std::filesystem::exists(folder / name); });
}

std::optional<std::int64_t> Checkpoints::newest_step(const std::filesystem::path& folder) {
  std::optional<std::int64_t> newest;
  for (const char* name : checkpoint_names) {
    if (!std::filesystem::exists(folder / name)) continue;
    try {
      newest = std::max(newest.value_or(0), checkpoint_step(folder / name));
    } catch (const InputError&) {
      // A damaged checkpoint counts as missing.
    }
  }
  return newest;
}

std::optional<std::filesystem::path> Checkpoints::newer_than(const std::filesystem::path& checkpoint) {
  const std::int64_t step = checkpoint_step(checkpoint);
  for (const char* name : checkpoint_names) {
    const std::filesystem::path other = checkpoint.parent_path() / name;
    if (checkpoint.filename() == name || !std::filesystem::exists(other)) continue;
    try {
      if (checkpoint_step(other) > step) return other;
    } catch (const InputError&) {
      // A damaged checkpoint does not count as newer.
    }
  }
  return {};
}

Checkpoints::Found Checkpoints::find_newest(const std::filesystem::path& folder) {
  const auto begin = std::chrono::steady_clock::now();
  Found newest;
  const auto note = [&](const InputError& error) {
    newest.fault += (newest.fault.empty() ? "" : "; ") + std::string(error.what());
  };
  std::vector<std::pair<std::int64_t, const char*>> files;
  for (const char* name : checkpoint_names) {
    if (!std::filesystem::exists(folder / name)) continue;
    try {
      files.emplace_back(checkpoint_step(folder / name), name);
    } catch (const InputError& error) {
      note(error);
    }
  }
  // Of two checkpoints of the same step the first name counts as the newer one.
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  // Packings are read one after the other, because the memory may not be enough for two.
  for (const auto& [step, name] : files) {
    try {
      newest.checkpoint = read_checkpoint(folder / name);
      newest.file = name;
      newest.seconds = since(begin).count();
      return newest;
    } catch (const InputError& error) {
      note(error);
    }
  }
  throw InputError(newest.fault.empty()
                       ? folder.string() + " holds no checkpoint; allowed: the folder of a run"
                       : newest.fault);
}

SaveCheckpoint::SaveCheckpoint(std::function<void()> save, double minutes, std::atomic<bool>& asked,
                               std::atomic<bool>& attention)
    : save_(std::move(save)),
      period_(std::chrono::duration_cast<Clock::duration>(
          std::chrono::duration<double, std::ratio<60>>(minutes))),
      asked_(asked),
      alarm_(attention) {
  alarm_.set(last_ + period_);
}

bool SaveCheckpoint::due(Observation&) { return asked_ || Clock::now() - last_ >= period_; }

std::optional<Verdict> SaveCheckpoint::fire(Observation& now) {
  asked_ = false;
  // A state with a fault is not saved. The Monitor decides at fixed steps whether the fault ends the run, so
  // that the result does not depend on the time of a checkpoint.
  if (fault_of(now.packing(), now.simulation().model()).empty()) save_();
  last_ = Clock::now();
  alarm_.set(last_ + period_);
  return {};
}

}  // namespace furnas
