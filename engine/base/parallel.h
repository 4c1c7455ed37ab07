#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace furnas {

struct Job;

/// The threads that the work of one simulation may use. On all of them arithmetic rounds to nearest and takes
/// numbers below 1e-308 for zero, whatever the rest of the program has set.
class Workers {
 public:
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const;

  /// Runs `work` with these threads; loops inside it use no others. The floating-point exceptions of the
  /// thread that begins it are raised for the caller.
  void run(const std::function<void()>& work);

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

/// Threads of this machine.
int available_threads();

namespace detail {
/// If set, called before each piece of a loop that threads share: so that a test can delay them as it likes.
inline std::atomic<void (*)()> before_piece = nullptr;

void run_chunks(std::size_t chunks, void (*call)(void*, std::size_t), void* body);

/// Whether this thread works for some Workers::run. Only then there is anybody to offer a job to.
bool at_work();

/// Leaves a job to whichever of these threads is free first.
void offer(Job& job);

/// Takes part in jobs and in loops until `open` is 0.
void help_until_none(const std::atomic<std::size_t>& open);
}  // namespace detail

/// Calls body(begin, end, chunk) for each piece of [0, count) of `size` elements. The pieces depend on
/// `count` and `size` alone, never on the number of threads.
template <class Body>
void for_chunks(std::size_t count, std::size_t size, Body&& body) {
  struct Loop {
    std::size_t count, size;
    Body& body;
  } loop{count, size, body};
  detail::run_chunks((count + size - 1) / size,
                     [](void* data, std::size_t chunk) {
                       Loop& l = *static_cast<Loop*>(data);
                       const std::size_t begin = chunk * l.size;
                       l.body(begin, std::min(begin + l.size, l.count), chunk);
                     },
                     &loop);
}

/// The sum of body(begin, end) over the pieces of [0, count), added in the order of the pieces: the
/// same bits for any number of threads.
template <class T, class Body>
T ordered_sum(std::size_t count, std::size_t size, Body&& body) {
  std::vector<T> parts((count + size - 1) / size);
  for_chunks(count, size,
             [&](std::size_t begin, std::size_t end, std::size_t chunk) { parts[chunk] = body(begin, end); });
  T sum{};
  for (const T& part : parts) sum += part;
  return sum;
}

}  // namespace furnas
