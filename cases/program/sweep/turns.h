#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "cases/program/sweep/worker.h"

namespace furnas {

/// One record of a sample. A turn is the time for which one worker has the sample.
struct TurnRecord {
  enum class Kind {
    none,   ///< no worker has had the sample yet
    taken,  ///< a worker has begun a turn, whose number is that of this record
    left,   ///< the turn before this record has ended, and the sample is saved
    done    ///< the turn before this record has ended, and the sample is finished or has failed
  };
  int number = 0;
  Kind kind = Kind::none;
  std::string worker;
  int code = 0;  ///< exit code of the run of a sample that is done
};

/// The records of which worker runs which sample of a sweep, shared by all workers.
///
/// Each sample has records 1, 2, 3 ..., each a file in the folder `turns`; no record is ever changed or
/// removed. link() creates a record with its whole content; if several workers try it, exactly one succeeds,
/// on NFS, too. A worker whose sample was taken over cannot end its turn, because the number of that record
/// exists already. The method needs no locks, clocks or dates of files. A worker that sees an old state of
/// the folder, as caches of NFS show it for a while, tries a number that exists already, and fails.
class Turns {
 public:
  /// `worker` is the worker whose turns are recorded here.
  Turns(std::filesystem::path sweep, const Worker& worker);

  /// The name of a sample in the records: the path of its folder, relative to the folder of the sweep.
  std::string key_of(const std::filesystem::path& sample) const;

  /// Reads the records of other workers.
  void look();

  /// The last record of a sample that was seen.
  TurnRecord last(const std::string& sample) const;

  /// Whether the last record is from the time before this worker began.
  bool is_old(const std::string& sample) const;

  /// Begins a turn at the sample, after the last record. Returns its number; empty if another worker was
  /// first.
  std::optional<int> take(const std::string& sample);

  /// Ends this worker's turn. False if the sample was taken over.
  bool end(const std::string& sample, int turn, TurnRecord::Kind kind, int code = 0);

  /// Whether another worker has taken the sample over.
  bool lost(const std::string& sample, int turn) const;

 private:
  std::filesystem::path file(const std::string& sample, int number) const;
  bool write(const std::string& sample, const TurnRecord& record);

  std::filesystem::path folder_;
  const Worker& worker_;
  std::map<std::string, TurnRecord> last_;
  std::map<std::string, int> at_begin_;  ///< numbers of the last records at the beginning
};

}  // namespace furnas
