#include "cases/signals.h"

#include <csignal>

namespace furnas {
namespace {

std::atomic<Requests*> current{nullptr};
static_assert(std::atomic<Requests*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

void ask_to_stop(int signal) {
  Requests* requests = current;
  if (!requests || requests->stop) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  requests->stop = true;
  requests->attention = true;
}

void ask_to_save(int) {
  if (Requests* requests = current) {
    requests->save = true;
    requests->attention = true;
  }
}

}  // namespace

SignalGuard::SignalGuard(Requests& requests) {
  current = &requests;
  for (int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, ask_to_stop);
  std::signal(SIGUSR1, ask_to_save);
}

SignalGuard::~SignalGuard() {
  for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) std::signal(signal, SIG_DFL);
  current = nullptr;
}

}  // namespace furnas
