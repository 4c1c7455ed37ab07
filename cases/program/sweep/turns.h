#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "cases/program/sweep/worker.h"

namespace furnas {

/// One line in the book of a sample.
struct TurnRecord {
  enum class Kind {
    none,   ///< nobody has had the sample yet
    taken,  ///< a worker has begun a turn; its number is that of this record
    left,   ///< the turn before this record was ended, and the sample saved
    done    ///< ... and the sample has come to its end, whatever it was
  };
  int number = 0;
  Kind kind = Kind::none;
  std::string worker;
  int code = 0;  ///< of a sample that is done: exit code of its run
};

/// The book of who works on which sample of a sweep, shared by all workers.
///
/// Each sample has records 1, 2, 3 ..., a file each in the folder `turns`, which no one changes or removes.
/// A record is made with all it says by link(), which one worker wins and all others lose, on NFS, too. So a
/// worker whose sample was taken over cannot end its turn: the number for that is gone. No lock, no clock and
/// no file's date is asked. Whoever sees an old state of the folder, as caches of NFS show it for a while,
/// tries a number that is gone, and loses.
class Turns {
 public:
  /// `worker` writes its records here.
  Turns(std::filesystem::path sweep, const Worker& worker);

  /// The name of a sample in the book: the path of its folder, relative to the folder of the sweep.
  std::string key_of(const std::filesystem::path& sample) const;

  /// Reads what others have written.
  void look();

  /// The last record of a sample that was seen.
  TurnRecord last(const std::string& sample) const;

  /// Whether the last record is from the time before this worker began.
  bool is_old(const std::string& sample) const;

  /// Begins a turn at the sample, after the last record; its number, or nothing if another was first.
  std::optional<int> take(const std::string& sample);

  /// Ends this worker's turn. False if the sample was taken over.
  bool end(const std::string& sample, int turn, TurnRecord::Kind kind, int code = 0);

  /// Whether another has taken the sample over.
  bool lost(const std::string& sample, int turn) const;

 private:
  std::filesystem::path file(const std::string& sample, int number) const;
  bool write(const std::string& sample, const TurnRecord& record);

  std::filesystem::path folder_;
  const Worker& worker_;
  std::map<std::string, TurnRecord> last_;
  std::map<std::string, int> at_begin_;  ///< numbers
};

}  // namespace furnas
