#pragma once

#include <atomic>
#include <csignal>
#include <utility>
#include <vector>

namespace furnas {

/// Requests that signals make to a running simulation.
struct Requests {
  std::atomic<bool> attention{false};  ///< something below is set: the loop of steps must check it
  std::atomic<bool> stop{false};       ///< SIGINT, SIGTERM, SIGHUP, SIGXCPU: save and stop
  std::atomic<bool> save{false};       ///< SIGUSR1: save and continue
};

/// While this object exists, signals set `requests`; a second signal to stop ends the program at once. A
/// signal that was ignored before, as under nohup, stays ignored. Only one guard may live at a time.
class SignalGuard {
 public:
  explicit SignalGuard(Requests& requests);
  ~SignalGuard();
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

 private:
  void take(int signal, void (*handler)(int));

  std::vector<std::pair<int, struct sigaction>> taken_;  ///< signals and their earlier actions
};

}  // namespace furnas
