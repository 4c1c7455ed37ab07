#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace furnas::test {

/// Where threads wait for each other. To a phase of a step that only reads: so phases that meet do not depend
/// on each other.
class Meeting {
 public:
  explicit Meeting(int guests) : missing_(guests) {}

  /// Waits until all are there; false if some have not come within half a minute.
  bool attend() const {
    std::unique_lock lock(mutex_);
    --missing_;
    all_there_.notify_all();
    return all_there_.wait_for(lock, std::chrono::seconds(30), [&] { return missing_ <= 0; });
  }

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable all_there_;
  mutable int missing_;
};

}  // namespace furnas::test
