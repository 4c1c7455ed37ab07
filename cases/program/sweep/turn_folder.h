#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "cases/program/sweep/plan.h"

namespace furnas {

/// The folder in which a turn at a sample works: `<sample>.turn-<n>` beside the sample's folder. No other
/// turn writes there, so a worker that continues after its sample was taken over does no harm. Files of
/// earlier turns are copied, never moved. The folder of this turn is renamed to the sample's folder when the
/// end of the turn is recorded (turns.h).
class TurnFolder {
 public:
  TurnFolder(const Sample& sample, int turn);

  std::filesystem::path run() const { return path_ / "run"; }  ///< the folder of the run
  std::filesystem::path log() const { return path_ / "log"; }  ///< output of the run
  std::filesystem::path case_file() const { return path_ / "case.toml"; }
  bool exists() const;

  /// The step of the last progress line in log(); empty before the first line.
  std::optional<std::int64_t> last_step() const;

  /// Makes the folder. This changes the folder above, so that NFS asks the server for its present content
  /// instead of a remembered one. Throws OutputError.
  void make() const;

  /// Copies the newest saved state of the sample into it, if there is any. Throws OutputError.
  void fill() const;

  /// Moves its run and its log to their final places, and removes this folder and those of earlier turns. Any
  /// worker may call this, any number of times, once the turn has ended. Throws OutputError.
  void publish() const;

 private:
  void copy(const std::filesystem::path& from) const;
  void put_in_place() const;
  void remove_earlier() const;

  std::filesystem::path sample_;  ///< folder of the sample
  std::filesystem::path log_of_sample_;
  int turn_;
  std::filesystem::path path_;
};

}  // namespace furnas
