#include "cases/program/sweep/small_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/atomic_file.h"

namespace furnas {
namespace {

/// Returns the error number, 0 without an error.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

int write_small_file(const std::filesystem::path& path, std::string_view text, int flags) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) return errno;
  const int error = write_all(descriptor, text);
  // NFS reports a full disk when the file is closed.
  return ::close(descriptor) == 0 || error != 0 ? error : errno;
}

void require_written(const std::filesystem::path& path, int error) {
  if (error != 0)
    throw OutputError(fmt::format("{}: cannot write the file: {}", path.string(), std::strerror(error)));
}

}  // namespace furnas
