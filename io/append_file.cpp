#include "io/append_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <vector>

#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {

std::string to_text(const FileMark& mark) { return fmt::format("{} bytes {:016x}", mark.bytes, mark.hash); }

FileMark parse_mark(const std::string& text) {
  FileMark mark;
  constexpr std::string_view between = " bytes ";
  const char* const end = text.data() + text.size();
  const auto bytes = std::from_chars(text.data(), end, mark.bytes);
  if (bytes.ec == std::errc{} && std::string_view(bytes.ptr, end).starts_with(between)) {
    const auto hash = std::from_chars(bytes.ptr + between.size(), end, mark.hash, 16);
    constexpr std::ptrdiff_t digits = 16;
    if (hash.ec == std::errc{} && hash.ptr == end && end - bytes.ptr == std::ssize(between) + digits)
      return mark;
  }
  throw InputError("\"" + text + "\" is not the length and hash of a file");
}

AppendFile::AppendFile(std::filesystem::path path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("cannot create the file");
}

AppendFile::AppendFile(std::filesystem::path path, const FileMark& mark) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0 && errno == ENOENT)
    throw InputError(path_.string() +
                     ": the file is missing, and the run cannot continue without it; restore it");
  if (descriptor_ < 0) fail("cannot open the file");
  try {
    take_up(mark);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

AppendFile::~AppendFile() { ::close(descriptor_); }

void AppendFile::take_up(const FileMark& mark) {
  std::vector<char> block(std::size_t{1} << 20);
  while (bytes_ < mark.bytes) {
    const ssize_t got = ::read(descriptor_, block.data(), std::min(block.size(), mark.bytes - bytes_));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot read the file");
    if (got == 0) break;
    hasher_.add_bytes(block.data(), static_cast<std::size_t>(got));
    bytes_ += static_cast<std::uint64_t>(got);
  }
  if (bytes_ != mark.bytes || hasher_.value() != mark.hash)
    throw InputError(fmt::format(
        "{}: its first {} bytes are not those that the run had written when it was saved; restore the file",
        path_.string(), mark.bytes));
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes_)) != 0) fail("cannot cut the file");
}

void AppendFile::append(std::string_view bytes) {
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error = errno;
      // A failed write may leave half a row, which is cut off here. If that fails too, resuming the run cuts
      // it off.
      [[maybe_unused]] const int cut = ::ftruncate(descriptor_, static_cast<off_t>(bytes_));
      errno = error;
      fail("cannot write the file");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  hasher_.add_bytes(bytes.data(), bytes.size());
  bytes_ += bytes.size();
}

FileMark AppendFile::mark() {
  if (::fsync(descriptor_) != 0) fail("cannot write the file through to the disk");
  return {bytes_, hasher_.value()};
}

void AppendFile::fail(const char* what) const {
  throw OutputError(path_.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace furnas
