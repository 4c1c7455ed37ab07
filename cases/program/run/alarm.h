#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace furnas {

/// Calls a run to attention at a time of the wall clock, however long its steps take.
class Alarm {
 public:
  using Clock = std::chrono::steady_clock;

  /// Sets `attention` at the time that set() names.
  explicit Alarm(std::atomic<bool>& attention);
  ~Alarm();
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

  /// Rings once at `when`; a time that was set before is forgotten.
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
