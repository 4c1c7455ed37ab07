#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>

namespace furnas {

/// Work that any thread may take. Its `call` must not throw.
struct Job {
  void (*call)(Job&) = nullptr;
  Job* next = nullptr;  ///< the next job in the queue
};

/// A queue of waiting jobs, first in, first out.
class JobQueue {
 public:
  void push(Job& job);
  Job* pop();  ///< null if none waits

 private:
  Job* first_ = nullptr;
  Job* last_ = nullptr;
};

/// Threads that stay awake between the loops of a step. A loop of a step lasts about ten microseconds, and
/// waking a sleeping thread costs as much. Therefore helpers poll for work as long as the team exists.
///
/// There are two kinds of work. A job is done as a whole by the first free thread. The pieces of a loop are
/// distributed by index: each member begins with its own range of pieces, and then takes pieces that other
/// members have not begun. A member's range is nearly the same in each step, so that the data of its pieces
/// stay in its cache. A loop also completes when a member never joins in.
class Team {
 public:
  /// `members` counts the leader, who is member 0.
  explicit Team(int members);

  /// The loop of helper `member` (1, 2, ...), which works until the team is dismissed.
  void help(int member);

  /// Calls call(body, piece) for each piece on this thread, which is `member`, and on all free threads.
  /// Rethrows the first exception of a piece. Does nothing and returns false if the pieces cannot be shared,
  /// because the team has only one member or works on another loop.
  bool run(int member, std::size_t pieces, void (*call)(void*, std::size_t), void* body);

  /// Leaves a job to the first free thread.
  void offer(Job& job);

  /// This thread, which is `member`, works on jobs and pieces of loops until `open` is 0.
  void help_until_none(int member, const std::atomic<std::size_t>& open);

  /// Ends the loops of the helpers. At this time no job may wait and no loop may run.
  void dismiss();

 private:
  struct alignas(64) Range {
    std::atomic<std::size_t> next{0};
    std::size_t end = 0;
    std::size_t done = 0;      ///< pieces that its member has done in this loop
    double share = 0;          ///< of all pieces: the share that its member does
    std::uint64_t joined = 0;  ///< number of the last loop that its member has joined
  };

  template <class Condition>
  void help_until(int member, Condition&& met);
  void share_out(std::size_t pieces);
  void learn(std::size_t pieces);
  void close();
  bool is_open(std::uint64_t loop, int member) const;
  void join(int member);
  void work(int member);
  Job* take_job();

  const int members_;
  std::unique_ptr<Range[]> ranges_;
  void (*call_)(void*, std::size_t) = nullptr;
  void* body_ = nullptr;
  std::exception_ptr failure_;
  std::mutex failing_;
  std::atomic<bool> taken_{false};  ///< true while a member runs a loop
  JobQueue jobs_;
  std::mutex queueing_;
  alignas(64) std::atomic<std::uint64_t> loop_{1};  ///< number of the loop; odd while no loop can be joined
  std::atomic<std::size_t> waiting_{0};             ///< jobs
  std::atomic<bool> dismissed_{false};
  alignas(64) std::atomic<int> busy_{0};            ///< members that work on a loop begun by another member
  alignas(64) std::atomic<std::size_t> helped_{0};  ///< pieces that these members have done
};

}  // namespace furnas
