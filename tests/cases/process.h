#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace furnas {

/// How a process ended and what it said.
struct Ending {
  int code = -1;    ///< exit code; -1 if a signal ended it
  int signal = 0;   ///< that ended it
  double peak{};    ///< most memory it held, resident [bytes]
  std::string out;  ///< standard output and standard error together
};

/// The program of this build in a process of its own.
class Process {
 public:
  /// Starts it; `setting` is added to its environment.
  explicit Process(const std::vector<std::string>& arguments,
                   const std::map<std::string, std::string>& setting = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t id() const { return pid_; }
  void signal(int number) const;
  /// Whether it still runs.
  bool runs();
  /// Waits for its end; kills it after a time in which it must have ended.
  Ending wait();

 private:
  pid_t pid_ = -1;
  int status_ = 0;
  long peak_ = 0;  ///< [kB]
  bool over_ = false;
  std::filesystem::path said_;
};

/// Runs it to its end.
inline Ending ending_of(const std::vector<std::string>& arguments,
                        const std::map<std::string, std::string>& setting = {}) {
  return Process(arguments, setting).wait();
}

}  // namespace furnas
