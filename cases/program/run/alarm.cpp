#include "cases/program/run/alarm.h"

#include <csignal>

namespace furnas {

Alarm::Alarm(std::atomic<bool>& attention) : attention_(attention) {
  // Only the thread of the run may get signals, so that no handler runs in this helper thread.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { wait(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Alarm::~Alarm() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Alarm::set(Clock::time_point when) {
  {
    const std::lock_guard lock(mutex_);
    when_ = when;
  }
  changed_.notify_one();
}

void Alarm::wait() {
  std::unique_lock lock(mutex_);
  while (!over_) {
    if (when_ == Clock::time_point::max()) {  // wait_until() would overflow
      changed_.wait(lock);
      continue;
    }
    const Clock::time_point when = when_;
    changed_.wait_until(lock, when);
    if (over_ || when != when_ || Clock::now() < when) continue;
    when_ = Clock::time_point::max();
    attention_ = true;
  }
}

}  // namespace furnas
