#pragma once

#include <filesystem>

#include "cases/program/sweep/plan.h"

namespace furnas {

/// Where a turn at a sample works: `<sample>.turn-<n>` beside the sample's folder. No other turn writes
/// there, so that a worker that comes back after its sample was taken over harms nobody. What earlier turns
/// have left is copied, never moved; what this one has made is renamed into the sample's place when the turn
/// has ended in the book (turns.h).
class TurnFolder {
 public:
  TurnFolder(const Sample& sample, int turn);

  std::filesystem::path run() const { return path_ / "run"; }  ///< the folder of the run
  std::filesystem::path log() const { return path_ / "log"; }  ///< what the run prints
  std::filesystem::path case_file() const { return path_ / "case.toml"; }
  bool exists() const;

  /// Makes it. From then on NFS, too, shows what is beside it by now: a change of the folder above makes it
  /// ask the server. Throws OutputError.
  void make() const;

  /// Copies into it the newest that was saved of the sample, if there is any. Throws OutputError.
  void fill() const;

  /// Puts its run and its log into their places, and removes it with those of earlier turns. For any worker
  /// and any number of times once the turn has ended. Throws OutputError.
  void publish() const;

 private:
  void copy(const std::filesystem::path& from) const;
  void put_in_place() const;
  void remove_earlier() const;

  std::filesystem::path sample_;  ///< its folder
  std::filesystem::path log_of_sample_;
  int turn_;
  std::filesystem::path path_;
};

}  // namespace furnas
