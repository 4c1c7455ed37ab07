#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>

namespace furnas {

/// Work that any thread may take. Its call throws nothing.
struct Job {
  void (*call)(Job&) = nullptr;
  Job* next = nullptr;  ///< of those that wait with it
};

/// Jobs that wait, first come, first served.
class JobQueue {
 public:
  void push(Job& job);
  Job* pop();  ///< nothing if none waits

 private:
  Job* first_ = nullptr;
  Job* last_ = nullptr;
};

/// Threads that stay awake between the loops of a step. A loop of a step lasts some ten microseconds, and
/// waking a thread that sleeps costs as much; so helpers ask for work in a circle as long as the team exists.
///
/// There are two kinds of work. A job is taken whole, by whoever is free first. The pieces of a loop are
/// shared out by index: each member begins with its own range, the same in each pass of a step, so that the
/// pieces stay in its cache, and then takes from others what they have not begun. A member that never comes
/// is not missed.
class Team {
 public:
  /// `members` counts the leader, who is member 0.
  explicit Team(int members);

  /// What helper `member` (1, 2, ...) does until the team is dismissed.
  void help(int member);

  /// Calls call(body, piece) for each piece on this thread, which is `member`, and on those that are free.
  /// Throws what a piece has thrown. Does nothing and returns false where there is nobody to share with: the
  /// team has one member, or works on another loop.
  bool run(int member, std::size_t pieces, void (*call)(void*, std::size_t), void* body);

  /// Leaves a job to whoever is free first.
  void offer(Job& job);

  /// This thread, which is `member`, does jobs and pieces of loops until `open` is 0.
  void help_until_none(int member, const std::atomic<std::size_t>& open);

  /// Sends the helpers away. No job may wait, no loop run.
  void dismiss();

 private:
  struct alignas(64) Range {
    std::atomic<std::size_t> next{0};
    std::size_t end = 0;
    std::size_t done = 0;      ///< pieces that its member has done in this loop
    double share = 0;          ///< of all pieces, that its member does
    std::uint64_t joined = 0;  ///< the last loop that its member has helped in
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
  std::atomic<bool> taken_{false};  ///< by a member that runs a loop
  JobQueue jobs_;
  std::mutex queueing_;
  alignas(64) std::atomic<std::uint64_t> loop_{1};  ///< its number; odd while there is none to be had
  std::atomic<std::size_t> waiting_{0};             ///< jobs
  std::atomic<bool> dismissed_{false};
  alignas(64) std::atomic<int> busy_{0};            ///< members that look at another's loop
  alignas(64) std::atomic<std::size_t> helped_{0};  ///< pieces that they have done
};

}  // namespace furnas
