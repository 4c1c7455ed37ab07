#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace furnas {

/// So long after the last sign of life others may take a worker's samples over, unless it is told otherwise.
inline constexpr std::chrono::duration<double> usual_takeover{120};

/// This process, as one of several that share the samples of a sweep. While it lives, a thread changes a
/// counter in the file workers/<name> twelve times within the takeover time; the file also says how long that
/// time is, and which process of which machine this is.
class Worker {
 public:
  /// Throws OutputError when its file cannot be written.
  Worker(std::filesystem::path sweep, std::chrono::duration<double> takeover);
  /// Removes its file.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// "node17-4242-9f3c02aa": no other process has it, now or later.
  const std::string& name() const { return name_; }
  std::chrono::duration<double> takeover() const { return takeover_; }
  std::filesystem::path sweep() const { return file_.parent_path().parent_path(); }

  /// A file that no other process writes, for what gets a common name once it is whole.
  std::filesystem::path own_file(const std::string& name) const { return file_.string() + "~" + name; }

 private:
  bool beat();
  void beat_until_over();

  const std::chrono::duration<double> takeover_;
  const std::string name_;
  const std::filesystem::path file_;
  const std::string who_;  ///< what its file says behind the counter
  std::uint64_t beats_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread thread_;
};

/// What can be known of a worker.
enum class Life {
  alive,   ///< its counter has changed within its takeover time
  ended,   ///< it was a process of this machine, and is no more
  silent,  ///< its counter has not changed for its takeover time
};

/// Watches other workers. No clock but that of this process counts, and of its time only what was spent
/// looking: neither clocks that differ nor a pause of this process make anybody silent.
class Watch {
 public:
  using Clock = std::chrono::steady_clock;

  /// A worker whose file is gone, or that does not say its takeover time, has that of `own`.
  explicit Watch(const Worker& own) : folder_(own.sweep() / "workers"), takeover_(own.takeover()) {}

  /// Removes the files of workers that were processes of this machine.
  void remove_ended();

  /// Looks at a worker's file. To find one silent takes at least five looks, over its takeover time.
  Life life_of(const std::string& worker, Clock::time_point now = Clock::now());

 private:
  struct Seen {
    std::string text;  ///< of its file
    Clock::time_point last;
    std::chrono::duration<double> silence{0};
  };

  std::filesystem::path folder_;
  std::chrono::duration<double> takeover_;
  std::map<std::string, Seen> seen_;
};

}  // namespace furnas
