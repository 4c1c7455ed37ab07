#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace furnas {

struct Job;

/// The threads that the work of one simulation may use. On all of them arithmetic rounds to nearest and
/// treats numbers below 1e-308 as zero, whatever the rest of the program has set.
class Workers {
 public:
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const;

  /// Runs `work` with these threads; loops inside `work` use no others. Floating-point exceptions of the
  /// thread that calls `work` are raised again in the caller's thread.
  void run(const std::function<void()>& work);

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

/// Number of threads of this machine.
int available_threads();

namespace detail {
/// If set, called before each piece of a loop that threads share, so that a test can delay the threads.
inline std::atomic<void (*)()> before_piece = nullptr;

void run_chunks(std::size_t chunks, void (*call)(void*, std::size_t), void* body);

/// Whether this thread works within a Workers::run. Only then other threads exist that can take a job.
bool at_work();

/// Leaves a job to the first free thread of the same Workers::run.
void offer(Job& job);

/// This thread works on jobs and on loops until `open` is 0.
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

/// A value whose sum with another is the larger of the two, so that ordered_sum gives the largest.
struct Largest {
  double value{};
  void operator+=(const Largest& b) { value = b.value > value ? b.value : value; }
};

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
