#include "engine/base/parallel.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace furnas {

struct Workers::Arena {
  tbb::task_arena tbb;
};

Workers::Workers(int threads) : arena_(new Arena{tbb::task_arena(threads)}) { arena_->tbb.initialize(); }
Workers::~Workers() = default;

int Workers::threads() const { return arena_->tbb.max_concurrency(); }

void Workers::run(const std::function<void()>& work) { arena_->tbb.execute(work); }

int available_threads() { return tbb::info::default_concurrency(); }

void detail::run_chunks(std::size_t chunks, void (*call)(void*, std::size_t), void* body) {
  if (chunks <= 1 || tbb::this_task_arena::max_concurrency() == 1) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) call(body, chunk);
    return;
  }
  // Static: each worker sees the same pieces in every pass of a step, so they stay in its cache.
  tbb::parallel_for(
      std::size_t{0}, chunks, [&](std::size_t chunk) { call(body, chunk); }, tbb::static_partitioner{});
}

}  // namespace furnas
