// The program's own operator new, which all arrays of the standard library use.

#ifndef __SANITIZE_ADDRESS__

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t page = std::size_t{2} << 20;

/// Memory at a multiple of `alignment`, null if there is none. An array that fills pages of two megabytes is
/// placed on such pages, where the system gives them on request (`madvise` in
/// /sys/kernel/mm/transparent_hugepage/enabled): a step accesses partners all over its arrays, and with pages
/// of 4 kB the processor spends a fifth of its time on address translation. The last page is a large one only
/// if it is well filled, so that little is wasted.
void* allocate(std::size_t size, std::size_t alignment) {
  const std::size_t all = (size + page - 1) / page * page;
  const std::size_t large = all - size < size / 4 ? all : size / page * page;
  if (large == 0) return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  void* const memory = std::aligned_alloc(page, all);
  if (memory != nullptr) ::madvise(memory, large, MADV_HUGEPAGE);  // a request; the system may refuse it
  return memory;
}

}  // namespace

void* operator new(std::size_t size, std::align_val_t alignment) {
  while (true) {
    if (void* const memory = allocate(size == 0 ? 1 : size, static_cast<std::size_t>(alignment)))
      return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void* operator new(std::size_t size) {
  return operator new (size, std::align_val_t{__STDCPP_DEFAULT_NEW_ALIGNMENT__});
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

#endif
