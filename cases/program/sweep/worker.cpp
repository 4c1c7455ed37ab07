#include "cases/program/sweep/worker.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "cases/program/sweep/small_file.h"
#include "engine/base/numbers.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;

constexpr double beats_in_takeover = 12;

std::string first_line(const fs::path& path) {
  std::string line;
  std::getline(std::ifstream(path), line);
  return line;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

constexpr const char* unknown_machine = "?";

/// Identifies this start of this machine and the container in which numbers of processes are valid.
std::string this_machine() {
  std::error_code no_answer;
  const fs::path container = fs::read_symlink("/proc/self/ns/pid", no_answer);
  const std::string start = first_line("/proc/sys/kernel/random/boot_id");
  return start.empty() || container.empty() ? unknown_machine : start + "/" + container.string();
}

/// The start time of a process of this machine, in ticks since the machine started; "" when there is no such
/// process. The number of a process may be reused later, but not with the same start time.
std::string beginning_of(const std::string& process) {
  const std::string line = first_line("/proc/" + process + "/stat");
  const auto name_ends = line.rfind(')');
  if (name_ends == std::string::npos) return "";
  const std::vector<std::string> words = words_of(line.substr(name_ends + 1));
  constexpr std::size_t state = 0, begins = 19;
  const bool dead = words.size() <= begins || words[state] == "Z" || words[state] == "X";
  return dead ? "" : words[begins];
}

std::string new_name() {
  std::array<char, 65> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("{}-{}-{:08x}", host.data(), ::getpid(), std::random_device{}());
}

}  // namespace

Worker::Worker(const fs::path& sweep, Seconds takeover)
    : takeover_(takeover),
      name_(new_name()),
      file_(sweep / "workers" / name_),
      who_(fmt::format("{:.3f} {} {} {}", takeover.count(), this_machine(), ::getpid(),
                       beginning_of(std::to_string(::getpid())))) {
  require_written(file_, beat());
  // Only the thread of the sweep may get signals: a signal in this thread would not end a wait of the sweep.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { beat_until_over(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  thread_.join();
  ::unlink(file_.c_str());
}

int Worker::beat() {
  const std::string text = fmt::format("{:020} {}\n", ++beats_, who_);
  const int error = write_small_file(file_, text);
  if (error != ENOENT) return error;
  std::error_code left;
  fs::create_directories(file_.parent_path(), left);
  return write_small_file(file_, text);
}

void Worker::beat_until_over() {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, takeover_ / beats_in_takeover, [this] { return over_; })) {
    lock.unlock();
    beat();  // if the disk fails, this worker becomes silent; nothing else can be done
    lock.lock();
  }
}

Life Watch::life_of(const std::string& worker, Clock::time_point now) {
  const std::string text = first_line(folder_ / worker);
  const std::vector<std::string> words = words_of(text);
  Seconds takeover = takeover_;
  if (words.size() > 1) takeover = Seconds(number_in<double>(words[1]).value_or(takeover.count()));
  const auto [place, fresh] = seen_.try_emplace(worker, Seen{text, now});
  Seen& seen = place->second;
  if (fresh || seen.text != text) {
    seen = {text, now};
  } else {
    // After a longer gap this process was stopped itself, and perhaps the other worker too, so the gap does
    // not count in full.
    seen.silence += std::min(Seconds(now - seen.last), takeover / 4);
    seen.last = now;
  }
  if (seen.silence >= takeover) return Life::silent;
  const std::string here = this_machine();
  const bool of_this_machine = words.size() == 5 && words[2] == here && here != unknown_machine;
  return of_this_machine && beginning_of(words[3]) != words[4] ? Life::ended : Life::alive;
}

void Watch::remove_ended() {
  std::error_code left;  // another worker may do the same
  for (const auto& entry : fs::directory_iterator(folder_, left)) {
    const std::string name = entry.path().filename().string();
    if (life_of(name.substr(0, name.find('~'))) == Life::ended) fs::remove(entry.path(), left);
  }
}

}  // namespace furnas
