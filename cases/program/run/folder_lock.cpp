#include "cases/program/run/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "io/atomic_file.h"

namespace furnas {
namespace {

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}", ::getpid(), host.data());
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : path_(folder / file_name) {
  while (!try_once()) ::close(descriptor_);
  const std::string name = this_process() + "\n";
  // The name of the process only helps a refused user, so writing it may fail.
  [[maybe_unused]] const bool told =
      ::ftruncate(descriptor_, 0) == 0 && ::write(descriptor_, name.data(), name.size()) >= 0;
}

/// False if the file was removed by its last holder between opening and locking it.
bool FolderLock::try_once() {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw OutputError(path_.string() + ": cannot create the file: " + std::strerror(errno));
  while (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK)
      break;  // on a file system without locks a run without a lock is better than none
    ::close(descriptor_);
    std::string holder;
    std::getline(std::ifstream(path_), holder);
    throw FolderInUse(path_.parent_path().string() + " is in use" +
                      (holder.empty() ? "" : ": " + holder + " works in it") +
                      "; wait for it, or take another folder");
  }
  struct stat mine {
  }, there{};
  return ::fstat(descriptor_, &mine) == 0 && ::stat(path_.c_str(), &there) == 0 &&
         mine.st_ino == there.st_ino && mine.st_dev == there.st_dev;
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace furnas
