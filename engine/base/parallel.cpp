#include "engine/base/parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <cfenv>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace furnas {
namespace {

/// While it lives, this thread rounds to nearest and takes numbers below 1e-308 for zero, whatever its caller
/// has set. Such numbers mean nothing here, and arithmetic with them is 40 times slower.
class Arithmetic {
 public:
  Arithmetic() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
#ifdef __SSE2__
    constexpr unsigned flush_to_zero = 1 << 15;
    constexpr unsigned denormals_are_zero = 1 << 6;
    _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
#endif
  }
  ~Arithmetic() { std::fesetenv(&before_); }
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

 private:
  std::fenv_t before_{};
};

}  // namespace

struct Workers::Arena {
  tbb::task_arena tbb;
};

// oneTBB takes over the arithmetic of the thread that begins the arena, for all that ever work in it.
Workers::Workers(int threads) : arena_(new Arena{tbb::task_arena(threads)}) {
  const Arithmetic arithmetic;
  arena_->tbb.initialize();
}
Workers::~Workers() = default;

int Workers::threads() const { return arena_->tbb.max_concurrency(); }

void Workers::run(const std::function<void()>& work) {
  int raised = 0;
  arena_->tbb.execute([&] {
    work();
    raised = std::fetestexcept(FE_ALL_EXCEPT);
  });
  std::feraiseexcept(raised);
}

int available_threads() { return tbb::info::default_concurrency(); }

void detail::run_chunks(std::size_t chunks, void (*call)(void*, std::size_t), void* body) {
  if (chunks <= 1 || tbb::this_task_arena::max_concurrency() == 1) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) call(body, chunk);
    return;
  }
  const auto delay = before_piece.load(std::memory_order_relaxed);
  // Static: each worker sees the same pieces in every pass of a step, so they stay in its cache.
  tbb::parallel_for(
      std::size_t{0}, chunks,
      [&](std::size_t chunk) {
        if (delay) delay();
        call(body, chunk);
      },
      tbb::static_partitioner{});
}

}  // namespace furnas
