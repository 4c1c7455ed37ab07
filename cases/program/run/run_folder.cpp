#include "cases/program/run/run_folder.h"

#include <charconv>
#include <cmath>
#include <new>
#include <system_error>

#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace fs = std::filesystem;

namespace {

void require_made(const fs::path& folder, const std::error_code& error) {
  if (!error) return;
  const std::string what = "--out: the folder " + folder.string() + " cannot be made: " + error.message();
  if (error == std::errc::no_space_on_device || error == std::errc::io_error) throw OutputError(what);
  throw InputError(what);
}

/// Making an existing folder fails without changing it, so only one of several processes gets a name.
bool make_new(const fs::path& folder) {
  std::error_code error;
  const bool made = fs::create_directory(folder, error);
  require_made(folder, error);
  return made;
}

fs::path make_first_free(const fs::path& wanted) {
  make_folder(wanted.parent_path());
  fs::path candidate = wanted;
  for (int n = 2; fs::exists(candidate) || !make_new(candidate); ++n)
    candidate = wanted.string() + "-" + std::to_string(n);
  return candidate;
}

/// Whether the folder is empty except for its lock.
bool holds_nothing(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != FolderLock::file_name) return false;
  return true;
}

void refuse_unless_empty(const fs::path& folder) {
  if (fs::is_directory(folder) && holds_nothing(folder)) return;
  throw InputError("--out " + folder.string() +
                   ": already there and not empty; allowed: a new or empty folder (resume continues a run)");
}

void remove_unfinished(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".tmp") fs::remove(entry.path());
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  require_made(folder, error);
}

RunFolder::RunFolder(fs::path path, bool made) : path_(std::move(path)), made_(made) {
  try {
    lock_ = std::make_unique<FolderLock>(path_);
  } catch (...) {
    std::error_code still_used;
    if (made_) fs::remove(path_, still_used);
    throw;
  }
}

RunFolder RunFolder::create(const std::string& wanted, const fs::path& case_file) {
  if (wanted.empty()) return {make_first_free(fs::path("runs") / case_file.stem()), true};
  fs::path path = wanted;
  if (!path.has_filename()) path = path.parent_path();  // "a/" is "a"
  bool made = false;
  if (fs::exists(path)) {
    refuse_unless_empty(path);
  } else {
    if (path.has_parent_path()) make_folder(path.parent_path());
    made = make_new(path);
  }
  RunFolder folder(path, made);
  folder.kept_ = true;  // until it is known to be empty
  refuse_unless_empty(path);
  folder.kept_ = false;
  return folder;
}

RunFolder RunFolder::open(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputError(folder + " is no folder; allowed: the folder of a run");
  RunFolder opened(folder, false);
  opened.keep();
  remove_unfinished(opened.path());
  remove_unfinished(opened.path() / "frames");
  return opened;
}

RunFolder::~RunFolder() {
  if (!lock_ || kept_) return;
  std::error_code left;
  try {
    for (fs::directory_iterator entry(path_, left); entry != fs::directory_iterator(); entry.increment(left))
      if (entry->path().filename() != FolderLock::file_name) fs::remove_all(entry->path(), left);
  } catch (const std::bad_alloc&) {
  }  // neither this nor an error in `left` can be handled here
  lock_.reset();
  if (made_) fs::remove(path_, left);
}

std::chrono::seconds parse_duration(const std::string& text, const std::string& option) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const std::string unit(rest, end);
  const double scale = unit == "d" ? 86400 : unit == "h" ? 3600 : unit == "m" ? 60 : unit == "s" ? 1 : 0;
  const double seconds = value * scale;
  if (error != std::errc{} || scale == 0 || !(seconds > 0) || seconds > 1e9)
    throw InputError(option + " " + text +
                     (unit.empty() && error == std::errc{} ? ": seconds, minutes, hours or days? " : ": ") +
                     "allowed: a positive time with its unit, such as 90s, 30m, 2h or 1d");
  return std::chrono::seconds(static_cast<std::int64_t>(std::ceil(seconds)));
}

}  // namespace furnas
