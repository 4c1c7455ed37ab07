// A library to be preloaded: it makes one call on a file fail, or kills the process inside it.
//
//   FURNAS_FAULT_UNDER   only calls on files whose path begins so are counted
//   FURNAS_FAULT_AT      which of them fails, counted from 1; 0: none
//   FURNAS_FAULT_ERROR   the value of errno; 0: the process is killed instead, a write after its first half
//   FURNAS_FAULT_LASTS   if set, all later calls that would need room on the disk fail, too
//   FURNAS_FAULT_COUNT   a file for the number of calls, when the process ends

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

long number(const char* name) {
  const char* text = std::getenv(name);
  return text ? std::atol(text) : 0;
}

const char* const under = std::getenv("FURNAS_FAULT_UNDER");
const long fails_at = number("FURNAS_FAULT_AT");
const int error = static_cast<int>(number("FURNAS_FAULT_ERROR"));
const bool lasts = std::getenv("FURNAS_FAULT_LASTS") != nullptr;

std::atomic<long> calls{0};
std::array<std::atomic<bool>, 1024> ours{};  // descriptors of files that count

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool counts(const char* path) { return under && path && std::strncmp(path, under, std::strlen(under)) == 0; }
bool counts(int descriptor) {
  return descriptor >= 0 && static_cast<std::size_t>(descriptor) < ours.size() &&
         ours[static_cast<std::size_t>(descriptor)];
}
void set(int descriptor, bool value) {
  if (descriptor >= 0 && static_cast<std::size_t>(descriptor) < ours.size())
    ours[static_cast<std::size_t>(descriptor)] = value;
}

/// Whether this call is the one, or one after it that needs room, too.
bool fails(bool needs_room) {
  const long call = ++calls;
  if (fails_at == 0 || call < fails_at || (call > fails_at && !(lasts && needs_room))) return false;
  errno = error;
  return true;
}

[[noreturn]] void die() {
  ::kill(::getpid(), SIGKILL);
  while (true) ::pause();
}

/// Fails, or dies.
int failure() {
  if (error == 0) die();
  errno = error;
  return -1;
}

int open_file(const char* name, const char* path, int flags, mode_t mode) {
  const bool writes = (flags & O_ACCMODE) != O_RDONLY || (flags & O_DIRECTORY) != 0;
  const bool counted = writes && counts(path);
  if (counted && fails((flags & O_CREAT) != 0)) return failure();
  const int descriptor = next<int(const char*, int, ...)>(name)(path, flags, mode);
  set(descriptor, counted);
  return descriptor;
}

/// Writes, or as much as there is room for.
template <class Write>
ssize_t write_with(Write real, int descriptor, const void* bytes, size_t size) {
  if (!counts(descriptor) || !fails(true)) return real(descriptor, bytes, size);
  const ssize_t half = real(descriptor, bytes, size / 2);
  return error != 0 && half > 0 ? half : failure();
}

struct Report {
  ~Report() {
    const char* path = std::getenv("FURNAS_FAULT_COUNT");
    if (!path) return;
    std::array<char, 32> text{};
    const int length = std::snprintf(text.data(), text.size(), "%ld", calls.load());
    const long descriptor = ::syscall(SYS_open, path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::syscall(SYS_write, descriptor, text.data(), length);
    ::syscall(SYS_close, descriptor);
  }
} report;

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(list, mode_t) : 0;
  va_end(list);
  return open_file("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(list, mode_t) : 0;
  va_end(list);
  return open_file("open64", path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  const auto real = next<ssize_t(int, const void*, size_t)>("write");
  return write_with(real, descriptor, bytes, size);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t at) {
  const auto real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  const auto there = [&](int file, const void* from, size_t count) { return real(file, from, count, at); };
  return write_with(there, descriptor, bytes, size);
}

int fsync(int descriptor) {
  if (counts(descriptor) && fails(true)) return failure();
  return next<int(int)>("fsync")(descriptor);
}

int ftruncate(int descriptor, off_t size) noexcept {
  if (counts(descriptor) && fails(false)) return failure();
  return next<int(int, off_t)>("ftruncate")(descriptor, size);
}

int close(int descriptor) {
  const bool counted = counts(descriptor);
  set(descriptor, false);
  const bool failed = counted && fails(false);
  if (failed && error == 0) die();
  const int result = next<int(int)>("close")(descriptor);
  return failed ? failure() : result;
}

int rename(const char* from, const char* to) noexcept {
  if (counts(to) && fails(true)) return failure();
  return next<int(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (counts(path) && fails(true)) return failure();
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
