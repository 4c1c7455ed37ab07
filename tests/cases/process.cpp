#include "tests/cases/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "tests/io/packings.h"

extern char** environ;

namespace furnas {
namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> found;
  for (std::string& word : words) found.push_back(word.data());
  found.push_back(nullptr);
  return found;
}

std::vector<std::string> environment(const std::map<std::string, std::string>& setting) {
  std::vector<std::string> all;
  for (char** one = environ; *one; ++one) all.emplace_back(*one);
  for (const auto& [name, value] : setting) all.push_back(name + "=" + value);
  return all;
}

std::filesystem::path fresh_file() {
  std::string name = (std::filesystem::temp_directory_path() / "furnas_said_XXXXXX").string();
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) throw std::runtime_error("no temporary file");
  ::close(descriptor);
  return name;
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& setting)
    : said_(fresh_file()) {
  std::vector<std::string> words{FURNAS_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> settings = environment(setting);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, said_.c_str(), O_WRONLY | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  const int error = ::posix_spawn(&pid_, FURNAS_PROGRAM, &actions, nullptr, pointers(words).data(),
                                  pointers(settings).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " FURNAS_PROGRAM);
}

Process::~Process() {
  if (runs()) {
    signal(SIGKILL);
    ::waitpid(pid_, &status_, 0);
  }
  std::filesystem::remove(said_);
}

void Process::signal(int number) const {
  if (!over_) ::kill(pid_, number);
}

bool Process::runs() {
  struct rusage used {};
  if (!over_) over_ = ::wait4(pid_, &status_, WNOHANG, &used) == pid_, peak_ = used.ru_maxrss;
  return !over_;
}

Ending Process::wait() {
  // Only what hangs takes so long, on a busy machine and under a sanitizer too.
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(20);
  while (runs()) {
    if (std::chrono::steady_clock::now() > end) signal(SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  Ending ending;
  if (WIFEXITED(status_)) ending.code = WEXITSTATUS(status_);
  if (WIFSIGNALED(status_)) ending.signal = WTERMSIG(status_);
  ending.peak = 1024.0 * static_cast<double>(peak_);
  ending.out = content(said_);
  return ending;
}

}  // namespace furnas
