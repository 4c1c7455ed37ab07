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

/// Waits until `met()`: at first by spinning, later by yielding the processor to other threads.
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

void JobQueue::push(Job& job) {
  job.next = nullptr;
  (first_ == nullptr ? first_ : last_->next) = &job;
  last_ = &job;
}

Job* JobQueue::pop() {
  Job* const job = first_;
  if (job != nullptr) first_ = job->next;
  return job;
}

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

template <class Condition>
void Team::help_until(int member, Condition&& met) {
  while (true) {
    wait_until([&] { return waiting_ != 0 || is_open(loop_, member) || met(); });
    if (Job* job = take_job())
      job->call(*job);
    else if (is_open(loop_, member))
      join(member);
    else if (met())
      return;
  }
}

void Team::help(int member) {
  help_until(member, [&] { return dismissed_.load(); });
}

void Team::help_until_none(int member, const std::atomic<std::size_t>& open) {
  help_until(member, [&] { return open == 0; });
}

bool Team::is_open(std::uint64_t loop, int member) const {
  return loop % 2 == 0 && loop != ranges_[static_cast<std::size_t>(member)].joined;
}

void Team::join(int member) {
  ++busy_;
  // The loop may have been closed in the meantime. That does no harm, because the member that runs the loop
  // waits for all busy members before it changes anything.
  const std::uint64_t loop = loop_;
  if (is_open(loop, member)) {
    ranges_[static_cast<std::size_t>(member)].joined = loop;
    work(member);
    // The counter is increased once for all pieces, because writing to a cache line that all threads write
    // costs as much as a piece of work.
    const std::size_t done = ranges_[static_cast<std::size_t>(member)].done;
    if (done != 0) helped_.fetch_add(done, std::memory_order_acq_rel);
  }
  --busy_;
}

void Team::close() {
  if (loop_ % 2 == 0) ++loop_;
  wait_until([&] { return busy_ == 0; });
}

bool Team::run(int member, std::size_t pieces, void (*call)(void*, std::size_t), void* body) {
  if (members_ == 1 || taken_.exchange(true, std::memory_order_acquire)) return false;
  call_ = call;
  body_ = body;
  share_out(pieces);
  helped_ = 0;
  ++loop_;
  work(member);
  wait_until([&] { return ranges_[static_cast<std::size_t>(member)].done + helped_ == pieces; });
  close();
  learn(pieces);
  const std::exception_ptr failure = std::exchange(failure_, nullptr);
  taken_.store(false, std::memory_order_release);
  if (failure) std::rethrow_exception(failure);
  return true;
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
  ranges_[static_cast<std::size_t>(member)].done = done;
}

void Team::offer(Job& job) {
  const std::lock_guard lock(queueing_);
  jobs_.push(job);
  ++waiting_;
}

Job* Team::take_job() {
  if (waiting_ == 0) return nullptr;
  const std::lock_guard lock(queueing_);
  Job* const job = jobs_.pop();
  if (job != nullptr) --waiting_;
  return job;
}

void Team::dismiss() {
  close();
  dismissed_ = true;
}

}  // namespace furnas
