// A library to be preloaded: the process seems to run on another machine, whose clocks are ahead and whose
// processes cannot be seen from here.
//
//   FURNAS_OTHER_MACHINE   which: its clocks are so many days ahead

#include <dlfcn.h>
#include <pthread.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

time_t ahead() {
  static const char* const machine = std::getenv("FURNAS_OTHER_MACHINE");
  return machine ? std::atol(machine) * 86400 : 0;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool counts(clockid_t clock) { return clock == CLOCK_REALTIME || clock == CLOCK_MONOTONIC; }

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, struct timespec* time) {
  const int result = next<int(clockid_t, struct timespec*)>("clock_gettime")(clock, time);
  if (result == 0 && counts(clock)) time->tv_sec += ahead();
  return result;
}

/// Waits until a time that the process has read from its own clock.
int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const struct timespec* until) {
  struct timespec ours = *until;
  if (counts(clock)) ours.tv_sec -= ahead();
  return next<int(pthread_cond_t*, pthread_mutex_t*, clockid_t, const struct timespec*)>(
      "pthread_cond_clockwait")(condition, mutex, clock, &ours);
}

ssize_t readlink(const char* path, char* text, size_t size) {
  const char* const machine = std::getenv("FURNAS_OTHER_MACHINE");
  if (!machine || std::strcmp(path, "/proc/self/ns/pid") != 0)
    return next<ssize_t(const char*, char*, size_t)>("readlink")(path, text, size);
  const int length = std::snprintf(text, size, "pid:[%s]", machine);
  return length < static_cast<int>(size) ? length : static_cast<ssize_t>(size);
}
}
