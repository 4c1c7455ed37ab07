#include "cases/program/run/signals.h"

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
  for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) take(signal, ask_to_stop);
  take(SIGUSR1, ask_to_save);
  // When the reader of the output has gone, or a file exceeds a size limit, the signal must not end the
  // program before it has saved. The write then fails, and the failure is reported.
  take(SIGPIPE, SIG_IGN);
  take(SIGXFSZ, SIG_IGN);
}

void SignalGuard::take(int signal, void (*handler)(int)) {
  struct sigaction action {
  }, before{};
  sigaction(signal, nullptr, &before);
  // nohup, or a shell that starts a job in the background, has set the signal to be ignored.
  if (before.sa_handler == SIG_IGN && signal != SIGUSR1) return;
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
  taken_.emplace_back(signal, before);
}

SignalGuard::~SignalGuard() {
  for (const auto& [signal, before] : taken_) sigaction(signal, &before, nullptr);
  current = nullptr;
}

}  // namespace furnas
