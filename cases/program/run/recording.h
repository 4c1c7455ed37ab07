#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "cases/program/run/alarm.h"
#include "cases/program/run/continuation.h"
#include "engine/compaction.h"
#include "io/checkpoint.h"
#include "io/frames_pvd.h"
#include "io/history.h"

namespace furnas {

/// Adds a row to history.csv at a fixed interval of steps.
class RecordHistory final : public Event {
 public:
  RecordHistory(const std::filesystem::path& folder, std::int64_t period)
      : path_(folder / "history.csv"), period_(period) {}
  const char* name() const override { return "history"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, period_); }
  std::optional<Verdict> fire(Observation& now) override;
  std::string saved() override { return to_text(history_->mark()); }
  void restore(const std::string& saved) override;

 private:
  std::filesystem::path path_;
  std::int64_t period_;
  std::optional<History> history_;  ///< from restore() on
};

/// When frames are written, besides the start; 0 switches a rule off.
struct FrameRhythm {
  std::int64_t steps{};  ///< from one frame to the next
  double phi{};          ///< a frame when phi first exceeds each multiple of this
};

/// Writes frames for ParaView, including the start, and keeps frames.pvd up to date.
class RecordFrame final : public Event {
 public:
  RecordFrame(std::filesystem::path folder, FrameRhythm rhythm)
      : folder_(std::move(folder)), rhythm_(rhythm) {}
  const char* name() const override { return "frame"; }
  std::int64_t next(std::int64_t step) const override;
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;
  std::string saved() override;
  void restore(const std::string& saved) override;

 private:
  void remove_later_frames() const;
  void make_frames_folder() const;
  std::int64_t multiple_below(Observation& now);

  std::filesystem::path folder_;
  FrameRhythm rhythm_;
  double sphere_volume_ = 0;        ///< of all spheres [d_s^3]; 0: not computed yet
  std::int64_t highest_ = 0;        ///< largest multiple of rhythm_.phi that phi has exceeded at a frame
  std::vector<SavedFrame> frames_;  ///< so far
};

/// The two checkpoints of a run, written in turn, so that one good one always stays.
class Checkpoints {
 public:
  /// The newest undamaged checkpoint of a folder.
  struct Found {
    Checkpoint checkpoint;
    std::string file;   ///< its name
    std::string fault;  ///< what is wrong with the newer one; empty if there is none
    double seconds{};   ///< that reading took
  };

  /// For a new run.
  explicit Checkpoints(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// For a run that continues from the checkpoint `file`, which is kept until the other one is written;
  /// reading it took `seconds`.
  Checkpoints(std::filesystem::path folder, const std::string& file, double seconds);

  /// Overwrites the older checkpoint. The caller has checked that the packing is sound.
  void write(const CheckpointView& checkpoint);

  /// The longest time to write a checkpoint; before the first, the time to read one.
  std::chrono::duration<double> longest() const { return longest_; }

  /// Whether a folder has no checkpoint yet.
  static bool none(const std::filesystem::path& folder);

  /// The step of the newer checkpoint of a folder; empty if no checkpoint has a readable step.
  static std::optional<std::int64_t> newest_step(const std::filesystem::path& folder);

  /// The other checkpoint of a folder, if it is undamaged and of a later step.
  static std::optional<std::filesystem::path> newer_than(const std::filesystem::path& checkpoint);

  /// Throws InputError naming the faults of both when none can be read.
  static Found find_newest(const std::filesystem::path& folder);
  static Checkpoint read_newest(const std::filesystem::path& folder) {
    return find_newest(folder).checkpoint;
  }

 private:
  std::filesystem::path folder_;
  bool second_ = false;
  std::chrono::duration<double> longest_{0};
};

/// Saves a checkpoint at an interval of minutes, and on request. It does not save a diverged state, so that
/// the last good checkpoint is kept; the Monitor ends such a run.
class SaveCheckpoint final : public Event {
 public:
  using Clock = std::chrono::steady_clock;

  /// `save` writes the checkpoint. `asked` is set from outside to request one; the event itself sets
  /// `attention` when a checkpoint is due.
  SaveCheckpoint(std::function<void()> save, double minutes, std::atomic<bool>& asked,
                 std::atomic<bool>& attention);
  const char* name() const override { return "checkpoint"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 100); }
  bool due(Observation& now) override;
  bool heeds_attention() const override { return true; }
  std::optional<Verdict> fire(Observation& now) override;

 private:
  std::function<void()> save_;
  Clock::duration period_;
  std::atomic<bool>& asked_;
  Clock::time_point last_ = Clock::now();
  Alarm alarm_;
};

}  // namespace furnas
