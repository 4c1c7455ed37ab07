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

/// Adds a row to history.csv every so many steps.
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

/// When frames are taken besides the start; 0: not by that.
struct FrameRhythm {
  std::int64_t steps{};  ///< from one frame to the next
  double phi{};          ///< at its multiples, each when phi first exceeds it
};

/// Writes frames for ParaView, the start among them, and keeps frames.pvd in step.
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
  double sphere_volume_ = 0;        ///< of all spheres [d_s^3]; 0: not asked yet
  std::int64_t highest_ = 0;        ///< multiple of rhythm_.phi that phi has exceeded at a frame
  std::vector<SavedFrame> frames_;  ///< so far
};

/// The two checkpoints of a run, written in turn, so that one good one always stays.
class Checkpoints {
 public:
  /// The newest checkpoint of a folder that is good.
  struct Found {
    Checkpoint checkpoint;
    std::string file;   ///< its name
    std::string fault;  ///< what is wrong with the newer one; empty if there is none
    double seconds{};   ///< that reading took
  };

  /// For a run that begins.
  explicit Checkpoints(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// For a run that goes on from the checkpoint `file`, which stays until the other one is written; reading
  /// it took `seconds`.
  Checkpoints(std::filesystem::path folder, const std::string& file, double seconds);

  /// Writes over the older one; throws NumericalFailure for a packing that is none, which must not take the
  /// place of a good one.
  void write(const CheckpointView& checkpoint);

  /// The longest that a checkpoint has taken; before the first, what reading one took.
  std::chrono::duration<double> longest() const { return longest_; }

  /// Whether a folder has none yet.
  static bool none(const std::filesystem::path& folder);

  /// The step of the newer checkpoint of a folder; none without one that tells its step.
  static std::optional<std::int64_t> newest_step(const std::filesystem::path& folder);

  /// The other checkpoint of a folder, if it is good and of a later step.
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

/// Saves a checkpoint every so many minutes, and when asked to; a state that has diverged it refuses, so that
/// the last good one stays, and ends the run.
class SaveCheckpoint final : public Event {
 public:
  using Clock = std::chrono::steady_clock;

  /// `save` writes everything that the run needs to go on; `asked` is set from outside, `attention` by the
  /// event itself when a checkpoint is due.
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
