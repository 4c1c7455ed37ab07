#pragma once

#include <atomic>

namespace furnas {

/// What signals ask of a running simulation.
struct Requests {
  std::atomic<bool> attention{false};  ///< something below is set: look up from the steps
  std::atomic<bool> stop{false};       ///< SIGINT, SIGTERM, SIGHUP: save and stop
  std::atomic<bool> save{false};       ///< SIGUSR1: save and go on
};

/// Lets the signals set `requests` while it lives; a second signal to stop ends the program at once. One at
/// a time.
class SignalGuard {
 public:
  explicit SignalGuard(Requests& requests);
  ~SignalGuard();
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;
};

}  // namespace furnas
