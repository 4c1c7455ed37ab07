#include "engine/base/parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <memory>
#include <utility>

#include "engine/base/require.h"
#include "engine/base/team.h"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace furnas {
namespace {

/// While an object of this class lives, its thread rounds to nearest and treats numbers below 1e-308 as zero,
/// whatever the caller has set. Such numbers have no physical meaning here, and arithmetic with them is 40
/// times slower.
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

/// The team that this thread belongs to, if any, and this thread's number in the team.
struct Seat {
  Team* team = nullptr;
  int member = 0;
};
thread_local Seat seat;

/// While an object of this class lives, its thread has another seat.
class Seated {
 public:
  explicit Seated(Seat mine) : before_(std::exchange(seat, mine)) {}
  ~Seated() { seat = before_; }
  Seated(const Seated&) = delete;
  Seated& operator=(const Seated&) = delete;

 private:
  Seat before_;
};

/// The work of a helper, as a task. The task passes from one thread to another inside the oneTBB library,
/// where ThreadSanitizer cannot see the synchronization. Therefore both threads also synchronize through
/// `put_down`.
class Helper {
 public:
  Helper(std::shared_ptr<Team> team, int member) : team_(std::move(team)), member_(member) {}
  Helper(Helper&& other) noexcept : team_(std::move(other.team_)), member_(other.member_) {
    put_down.fetch_add(1, std::memory_order_release);
  }
  void operator()() const {
    put_down.load(std::memory_order_acquire);
    const Seated here({team_.get(), member_});
    team_->help(member_);
  }

 private:
  inline static std::atomic<unsigned> put_down{0};

  std::shared_ptr<Team> team_;
  int member_;
};

}  // namespace

/// Work begins in an arena of one thread. The helpers run in an arena of their own, so that no thread waits
/// for a task that only a helper could run.
struct Workers::Arena {
  explicit Arena(int wanted) : threads(wanted), helpers(std::max(wanted - 1, 1), 0) {
    require(wanted >= 1, "a thread is needed to work");
  }
  int threads;
  tbb::task_arena leader{1};
  tbb::task_arena helpers;
};

// oneTBB copies the floating-point settings of the thread that initializes an arena to all threads that work
// in the arena.
Workers::Workers(int threads) : arena_(new Arena(threads)) {
  const Arithmetic arithmetic;
  arena_->leader.initialize();
  if (threads > 1) arena_->helpers.initialize();
}
Workers::~Workers() = default;

int Workers::threads() const { return arena_->threads; }

void Workers::run(const std::function<void()>& work) {
  // A helper may start only after all work is done. The shared pointer keeps the team alive for this helper,
  // which finds itself dismissed.
  const auto team = std::make_shared<Team>(arena_->threads);
  const struct Lead {
    Team& team;
    ~Lead() { team.dismiss(); }
  } lead{*team};
  for (int member = 1; member < arena_->threads; ++member) arena_->helpers.enqueue(Helper(team, member));
  int raised = 0;
  arena_->leader.execute([&] {
    const Seated here({team.get(), 0});
    work();
    raised = std::fetestexcept(FE_ALL_EXCEPT);
  });
  std::feraiseexcept(raised);
}

int available_threads() { return tbb::info::default_concurrency(); }

void detail::run_chunks(std::size_t chunks, void (*call)(void*, std::size_t), void* body) {
  struct Pieces {
    void (*call)(void*, std::size_t);
    void* body;
    void (*delay)();
    void operator()(std::size_t chunk) const {
      if (delay != nullptr) delay();
      call(body, chunk);
    }
  } pieces{call, body, before_piece.load(std::memory_order_relaxed)};
  const auto piece = [](void* data, std::size_t chunk) { (*static_cast<const Pieces*>(data))(chunk); };
  if (chunks > 1 && seat.team != nullptr && seat.team->run(seat.member, chunks, piece, &pieces)) return;
  if (chunks > 1 && seat.team == nullptr && tbb::this_task_arena::max_concurrency() > 1) {
    tbb::parallel_for(std::size_t{0}, chunks, pieces);
  } else {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) pieces(chunk);
  }
}

bool detail::at_work() { return seat.team != nullptr; }

void detail::offer(Job& job) { seat.team->offer(job); }

void detail::help_until_none(const std::atomic<std::size_t>& open) {
  seat.team->help_until_none(seat.member, open);
}

}  // namespace furnas
