#include "engine/base/team.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace furnas {
namespace {

/// Waits until `met`, awake at first, then leaving the processor to others.
template <class Condition>
void wait_until(Condition&& met) {
  constexpr int awake = 4000;
  for (int turn = 0; !met(); ++turn) {
    if (turn < awake) {
#ifdef __SSE2__
      _mm_pause();
#endif
    } else {
      std::this_thread::yield();
    }
  }
}

}  // namespace

Team::Team(int members)
    : members_(members), ranges_(std::make_unique<Range[]>(static_cast<std::size_t>(members))) {
  for (int m = 0; m < members; ++m) ranges_[static_cast<std::size_t>(m)].share = 1.0 / members;
}

void Team::share_out(std::size_t pieces) {
  double sum = 0;
  std::size_t begin = 0;
  for (int m = 0; m < members_; ++m) {
    Range& range = ranges_[static_cast<std::size_t>(m)];
    sum += range.share;
    const bool last = m + 1 == members_;
    range.next.store(begin, std::memory_order_relaxed);
    range.end =
        last ? pieces
             : std::min(pieces, static_cast<std::size_t>(std::lround(sum * static_cast<double>(pieces))));
    range.done = 0;
    begin = range.end;
  }
}

void Team::learn(std::size_t pieces) {
  const auto members = static_cast<std::size_t>(members_);
  if (pieces < 8 * members) return;
  constexpr double pace = 0.02;
  for (std::size_t m = 0; m < members; ++m) {
    Range& range = ranges_[m];
    range.share += pace * (static_cast<double>(range.done) / static_cast<double>(pieces) - range.share);
  }
}

void Team::help(int member) {
  std::uint64_t done = 0;
  while (true) {
    wait_until([&] {
      const std::uint64_t job = job_;
      return dismissed_ || (job != done && job % 2 == 0);
    });
    if (dismissed_) return;
    ++busy_;
    // Closed in the meantime, or not: the leader waits for those who are busy before it changes anything.
    const std::uint64_t job = job_;
    if (job % 2 == 0 && job != done) {
      work(member);
      done = job;
    }
    --busy_;
  }
}

void Team::close() {
  if (job_ % 2 == 0) ++job_;
  wait_until([&] { return busy_ == 0; });
}

void Team::run(std::size_t pieces, void (*call)(void*, std::size_t), void* body) {
  close();
  call_ = call;
  body_ = body;
  share_out(pieces);
  helped_ = 0;
  ++job_;
  work(0);
  wait_until([&] { return ranges_[0].done + helped_ == pieces; });
  close();
  learn(pieces);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Team::work(int member) {
  std::size_t done = 0;
  for (int n = 0; n < members_; ++n) {
    Range& range = ranges_[static_cast<std::size_t>((member + n) % members_)];
    while (true) {
      const std::size_t piece = range.next.fetch_add(1, std::memory_order_relaxed);
      if (piece >= range.end) break;
      try {
        call_(body_, piece);
      } catch (...) {
        const std::lock_guard lock(failing_);
        if (!failure_) failure_ = std::current_exception();
      }
      ++done;
    }
  }
  // Once for all of them: a line that both write costs as much as a piece of work.
  ranges_[static_cast<std::size_t>(member)].done = done;
  if (member != 0 && done != 0) helped_.fetch_add(done, std::memory_order_acq_rel);
}

void Team::dismiss() {
  close();
  dismissed_ = true;
}

}  // namespace furnas
