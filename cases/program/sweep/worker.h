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

/// The default time without a sign of life of a worker after which others may take its samples over.
inline constexpr std::chrono::duration<double> usual_takeover{120};

/// This process, as one of several that share the samples of a sweep. While this object exists, a thread
/// changes a counter in the file workers/<name> twelve times within the takeover time. The file also contains
/// the takeover time, the machine and the process.
class Worker {
 public:
  /// Throws OutputError when its file cannot be written.
  Worker(const std::filesystem::path& sweep, std::chrono::duration<double> takeover);
  /// Removes its file.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// "node17-4242-9f3c02aa": a name that no other process has, now or later.
  const std::string& name() const { return name_; }
  std::chrono::duration<double> takeover() const { return takeover_; }
  std::filesystem::path sweep() const { return file_.parent_path().parent_path(); }

  /// A file that no other process writes; when complete, it is renamed to a common name.
  std::filesystem::path own_file(const std::string& name) const { return file_.string() + "~" + name; }

 private:
  int beat();  ///< writes the counter; returns the error number, 0 without an error
  void beat_until_over();

  const std::chrono::duration<double> takeover_;
  const std::string name_;
  const std::filesystem::path file_;
  const std::string who_;  ///< text after the counter in its file
  std::uint64_t beats_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread thread_;
};

/// State of a worker, as another worker sees it.
enum class Life {
  alive,   ///< its counter has changed within its takeover time
  ended,   ///< it was a process of this machine and has ended
  silent,  ///< its counter has not changed for its takeover time
};

/// Watches other workers. It uses only the clock of this process, and of its time only that spent watching.
/// Therefore neither clocks that differ nor a pause of this process make another worker seem silent.
class Watch {
 public:
  using Clock = std::chrono::steady_clock;

  /// For a worker whose file is missing or has no takeover time, the takeover time of `own` is used.
  explicit Watch(const Worker& own) : folder_(own.sweep() / "workers"), takeover_(own.takeover()) {}

  /// Removes the files of workers that were processes of this machine.
  void remove_ended();

  /// Reads a worker's file. Finding a worker silent takes at least five calls, spread over its takeover time.
  Life life_of(const std::string& worker, Clock::time_point now = Clock::now());

 private:
  struct Seen {
    std::string text;  ///< content of the worker's file
    Clock::time_point last;
    std::chrono::duration<double> silence{0};
  };

  std::filesystem::path folder_;
  std::chrono::duration<double> takeover_;
  std::map<std::string, Seen> seen_;
};

}  // namespace furnas
