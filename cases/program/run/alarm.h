#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace furnas {

/// Sets a flag at a time of the wall clock, so that a run reacts even if its steps take long.
class Alarm {
 public:
  using Clock = std::chrono::steady_clock;

  /// Sets `attention` at the time that set() names.
  explicit Alarm(std::atomic<bool>& attention);
  ~Alarm();
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

  /// Sets the flag once at `when`, which replaces an earlier time.
  void set(Clock::time_point when);

 private:
  void wait();

  std::atomic<bool>& attention_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Clock::time_point when_ = Clock::time_point::max();
  bool over_ = false;
  std::thread thread_;
};

}  // namespace furnas
