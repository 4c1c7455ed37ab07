#include "engine/base/parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cfenv>
#include <utility>

#include "engine/base/team.h"

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

/// The team that helps this thread, if there is one.
thread_local Team* team = nullptr;

}  // namespace

/// Work begins in an arena of one thread. Its helpers come from another, so that nobody waits for a task that
/// only a helper could run.
struct Workers::Arena {
  int threads;
  tbb::task_arena leader{1};
  tbb::task_arena helpers;
};

// oneTBB takes over the arithmetic of the thread that begins an arena, for all that ever work in it.
Workers::Workers(int threads)
    : arena_(new Arena{threads, tbb::task_arena(1), tbb::task_arena(std::max(threads - 1, 1), 0)}) {
  const Arithmetic arithmetic;
  arena_->leader.initialize();
  if (threads > 1) arena_->helpers.initialize();
}
Workers::~Workers() = default;

int Workers::threads() const { return arena_->threads; }

void Workers::run(const std::function<void()>& work) {
  // A helper that comes when all is done finds itself dismissed, and the team still there.
  const auto helped = arena_->threads > 1 ? std::make_shared<Team>(arena_->threads) : nullptr;
  for (int member = 1; member < arena_->threads; ++member)
    arena_->helpers.enqueue([helped, member] { helped->help(member); });
  int raised = 0;
  arena_->leader.execute([&] {
    struct Lead {
      Team* mine;
      Team* before = std::exchange(team, mine);
      ~Lead() {
        team = before;
        if (mine != nullptr) mine->dismiss();
      }
    } const lead{helped.get()};
    work();
    raised = std::fetestexcept(FE_ALL_EXCEPT);
  });
  std::feraiseexcept(raised);
}

int available_threads() { return tbb::info::default_concurrency(); }

void detail::run_chunks(std::size_t chunks, void (*call)(void*, std::size_t), void* body) {
  struct Job {
    void (*call)(void*, std::size_t);
    void* body;
    void (*delay)();
    void operator()(std::size_t chunk) const {
      if (delay != nullptr) delay();
      call(body, chunk);
    }
  } job{call, body, before_piece.load(std::memory_order_relaxed)};
  if (chunks > 1 && team != nullptr) {
    team->run(
        chunks, [](void* data, std::size_t chunk) { (*static_cast<const Job*>(data))(chunk); }, &job);
  } else if (chunks > 1 && tbb::this_task_arena::max_concurrency() > 1) {
    tbb::parallel_for(std::size_t{0}, chunks, job);
  } else {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) job(chunk);
  }
}

}  // namespace furnas
