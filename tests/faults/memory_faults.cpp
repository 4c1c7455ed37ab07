// A library to be preloaded: it makes one request for memory fail.
//
//   FURNAS_FAULT_AFTER   requests are counted from the first fopen() of a file whose name ends so
//   FURNAS_FAULT_AT      which of them fails, counted from 1; 0: none
//   FURNAS_FAULT_LASTS   if set, all later requests for as much or more fail, too, but for those
//                        below 4 kB, which a sentence about it takes
//   FURNAS_FAULT_COUNT   a file for the number of requests, when the process ends

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

std::atomic<bool> armed{false};
std::atomic<long> requests{0};
std::atomic<size_t> largest{~size_t{0}};  // the size that failed

long fails_at = 0;
bool lasts = false;

__attribute__((constructor)) void set_up() {
  if (const char* at = std::getenv("FURNAS_FAULT_AT")) fails_at = std::atol(at);
  lasts = std::getenv("FURNAS_FAULT_LASTS") != nullptr;
}

__attribute__((destructor)) void report() {
  armed = false;
  const char* path = std::getenv("FURNAS_FAULT_COUNT");
  if (!path) return;
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), "%ld", requests.load());
  const long descriptor = ::syscall(SYS_open, path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ::syscall(SYS_write, descriptor, text.data(), length);
  ::syscall(SYS_close, descriptor);
}

bool fails(size_t size) {
  if (!armed) return false;
  const long request = ++requests;
  if (fails_at == 0 || request < fails_at) return false;
  if (request == fails_at) largest = std::max(size, size_t{4096});
  if (request > fails_at && !(lasts && size >= largest)) return false;
  errno = ENOMEM;
  return true;
}

std::FILE* open_file(const char* function, const char* path, const char* mode) {
  const char* after = std::getenv("FURNAS_FAULT_AFTER");
  const std::size_t length = std::strlen(path);
  if (after && length >= std::strlen(after) && std::strcmp(path + length - std::strlen(after), after) == 0)
    armed = true;
  return reinterpret_cast<std::FILE* (*)(const char*, const char*)>(dlsym(RTLD_NEXT, function))(path, mode);
}

}  // namespace

extern "C" {

void* malloc(size_t size) { return fails(size) ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails(count * size) ? nullptr : __libc_calloc(count, size); }
void* realloc(void* memory, size_t size) { return fails(size) ? nullptr : __libc_realloc(memory, size); }
void* memalign(size_t alignment, size_t size) {
  return fails(size) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }
int posix_memalign(void** memory, size_t alignment, size_t size) {
  *memory = memalign(alignment, size);
  return *memory ? 0 : ENOMEM;
}

std::FILE* fopen(const char* path, const char* mode) { return open_file("fopen", path, mode); }
std::FILE* fopen64(const char* path, const char* mode) { return open_file("fopen64", path, mode); }

}  // extern "C"
