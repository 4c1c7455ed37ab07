#include "io/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "engine/base/require.h"

namespace furnas {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;

/// Without this a crash may undo the rename although the file's bytes are on the disk.
bool sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return false;
  // Some file systems cannot sync a folder and return EINVAL; this is not an error.
  const bool done = ::fsync(descriptor) == 0 || errno == EINVAL;
  const int error = errno;
  ::close(descriptor);
  errno = error;
  return done;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += ".tmp";
  buffer_.reserve(buffer_size);
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("cannot create the file");
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  require(descriptor_ >= 0, "a committed file takes no more bytes");
  buffer_.append(bytes);
  if (buffer_.size() >= buffer_size) flush();
}

void AtomicFile::overwrite(std::uint64_t at, std::string_view bytes) {
  require(descriptor_ >= 0, "a committed file takes no more bytes");
  require(at <= size() && bytes.size() <= size() - at, "only bytes that were written can be overwritten");
  if (at >= flushed_) {
    buffer_.replace(static_cast<std::size_t>(at - flushed_), bytes.size(), bytes);
    return;
  }
  flush();
  write_at(at, bytes);
}

void AtomicFile::flush() {
  write_at(flushed_, buffer_);
  flushed_ += buffer_.size();
  buffer_.clear();
}

void AtomicFile::write_at(std::uint64_t at, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write the file");
    bytes.remove_prefix(static_cast<std::size_t>(written));
    at += static_cast<std::uint64_t>(written);
  }
}

void AtomicFile::commit() {
  require(descriptor_ >= 0, "a file is committed once");
  flush();
  if (::fsync(descriptor_) != 0) fail("cannot write the file through to the disk");
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot put the file in its place");
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot close the file");
  if (!sync_folder(path_.parent_path())) fail("cannot write the folder through to the disk");
}

void AtomicFile::fail(const char* what) const {
  throw OutputError(path_.string() + ": " + what + ": " + std::strerror(errno));
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

void refuse_existing(const std::filesystem::path& path) {
  if (std::filesystem::exists(path))
    throw InputError(path.string() + " exists and is not overwritten; give another name");
}

}  // namespace furnas
