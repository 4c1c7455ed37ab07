#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>

namespace furnas {

/// Threads that stay awake between the loops of a step. A loop of a step lasts some ten microseconds, and
/// waking a thread that sleeps costs as much; so helpers ask for work in a circle as long as the team exists.
///
/// The pieces of a loop are shared out by index: each member begins with its own range, the same in each pass
/// of a step, so that the pieces stay in its cache, and then takes from others what they have not begun. A
/// member that never comes is not missed.
class Team {
 public:
  /// `members` counts the leader.
  explicit Team(int members);

  /// What helper `member` (1, 2, ...) does until the team is dismissed.
  void help(int member);

  /// Calls call(body, piece) for each piece, with the help of those who are there; the leader alone may do
  /// so. Throws what a piece has thrown.
  void run(std::size_t pieces, void (*call)(void*, std::size_t), void* body);

  /// Sends the helpers away.
  void dismiss();

 private:
  struct alignas(64) Range {
    std::atomic<std::size_t> next{0};
    std::size_t end = 0;
    std::size_t done = 0;  ///< pieces that its member has done in this loop
    double share = 0;      ///< of all pieces, that its member does
  };

  void share_out(std::size_t pieces);
  void learn(std::size_t pieces);
  void close();
  void work(int member);

  const int members_;
  std::unique_ptr<Range[]> ranges_;
  void (*call_)(void*, std::size_t) = nullptr;
  void* body_ = nullptr;
  std::exception_ptr failure_;
  std::mutex failing_;
  alignas(64) std::atomic<std::uint64_t> job_{1};  ///< its number; odd while there is none to be had
  std::atomic<bool> dismissed_{false};
  alignas(64) std::atomic<int> busy_{0};            ///< helpers that look at the job
  alignas(64) std::atomic<std::size_t> helped_{0};  ///< pieces that helpers have done
};

}  // namespace furnas
