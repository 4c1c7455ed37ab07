#include "cases/program/sweep/turn_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <thread>
#include <vector>

#include "cases/program/run/folder_lock.h"
#include "cases/program/run/progress.h"
#include "cases/program/run/recording.h"
#include "cases/program/run/run_folder.h"
#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// Other turns at the same sample whose folders still exist, the latest first.
std::vector<int> turns_beside(const fs::path& sample) {
  const std::string begin = sample.filename().string() + ".turn-";
  std::vector<int> turns;
  for (const auto& entry : fs::directory_iterator(sample.parent_path()))
    if (const std::string name = entry.path().filename().string(); name.starts_with(begin))
      if (const auto turn = number_in<int>(name.substr(begin.size()))) turns.push_back(*turn);
  std::sort(turns.rbegin(), turns.rend());
  return turns;
}

fs::path folder_of_turn(const fs::path& sample, int turn) {
  return fmt::format("{}.turn-{}", sample.string(), turn);
}

void copy_file_whole(const fs::path& from, const fs::path& to) {
  std::ifstream file(from, std::ios::binary);
  if (!file) return;  // removed meanwhile, as a resumed run does with later frames
  AtomicFile copy(to);
  read_in_parts(file, from, [&](std::string_view part) { copy.write(part); });
  copy.commit();
}

/// Removes the files in an open folder, even if another folder now has its name.
void empty(int folder) {
  const int own = ::fcntl(folder, F_DUPFD_CLOEXEC, 0);
  DIR* const entries = ::fdopendir(own);
  if (!entries) {
    if (own >= 0) ::close(own);
    return;
  }
  ::rewinddir(entries);
  while (const dirent* entry = ::readdir(entries)) {
    const std::string name = entry->d_name;
    if (name == "." || name == ".." || ::unlinkat(folder, name.c_str(), 0) == 0) continue;
    const int below = ::openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (below < 0) continue;
    empty(below);
    ::close(below);
    ::unlinkat(folder, name.c_str(), AT_REMOVEDIR);
  }
  ::closedir(entries);
}

}  // namespace

TurnFolder::TurnFolder(const Sample& sample, int turn)
    : sample_(sample.folder),
      log_of_sample_(sample.log()),
      turn_(turn),
      path_(folder_of_turn(sample.folder, turn)) {}

bool TurnFolder::exists() const { return fs::exists(path_); }

std::optional<std::int64_t> TurnFolder::last_step() const {
  constexpr std::int64_t tail = 4096;  // longer than a few progress lines
  std::error_code none;
  const auto size = static_cast<std::int64_t>(fs::file_size(log(), none));
  std::ifstream file(log(), std::ios::binary);
  if (none || !file.seekg(std::max<std::int64_t>(size - tail, 0))) return {};
  return step_of_last_line(std::string{std::istreambuf_iterator<char>(file), {}});
}

void TurnFolder::make() const { make_folder(path_); }

void TurnFolder::fill() const {
  fs::path newest;
  std::int64_t most = -1;
  std::vector<fs::path> places{sample_};
  for (const int turn : turns_beside(sample_))
    if (turn < turn_) places.push_back(folder_of_turn(sample_, turn) / "run");
  for (const fs::path& place : places)
    if (const auto step = Checkpoints::newest_step(place); step && *step > most) newest = place, most = *step;
  if (!newest.empty()) copy(newest);
}

/// Copies the checkpoints first. The parts of other files that a checkpoint needs were written before it, and
/// those files only grow.
void TurnFolder::copy(const fs::path& from) const {
  const fs::path part = path_ / "part";
  fs::remove_all(part);
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from))
    if (entry.is_regular_file() && entry.path().extension() != ".tmp" &&
        entry.path().filename() != FolderLock::file_name)
      files.push_back(entry.path());
  std::stable_partition(files.begin(), files.end(),
                        [](const fs::path& file) { return file.extension() == ".checkpoint"; });
  for (const fs::path& file : files) {
    const fs::path to = part / fs::relative(file, from);
    make_folder(to.parent_path());
    copy_file_whole(file, to);
  }
  fs::rename(part, run());
}

void TurnFolder::publish() const {
  put_in_place();
  remove_earlier();
  std::error_code left;  // another worker may do the same
  fs::remove_all(path_, left);
}

/// A folder can be renamed onto an empty folder only, so the older folder is emptied first, through a
/// descriptor opened before the rename. Since the rename failed, the opened folder was not the folder of this
/// turn. Therefore the result of this turn is never deleted, even if this process pauses in between.
void TurnFolder::put_in_place() const {
  std::rename(log().c_str(), log_of_sample_.c_str());
  for (int tries = 0; tries < 5; ++tries) {
    const int older = ::open(sample_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int error = std::rename(run().c_str(), sample_.c_str()) == 0 ? 0 : errno;
    const bool occupied = error == ENOTEMPTY || error == EEXIST;
    if (occupied && older >= 0) empty(older);
    if (older >= 0) ::close(older);
    if (error == 0 || error == ENOENT) return;  // ENOENT: another worker has done it, or the run has no files
    if (!occupied)
      throw OutputError(
          fmt::format("{}: cannot put the folder in its place: {}", sample_.string(), std::strerror(error)));
    std::this_thread::sleep_for(std::chrono::milliseconds(100 * tries));
  }
  throw OutputError(sample_.string() +
                    ": the folder cannot be emptied, so the newer result of this sample cannot be put there");
}

void TurnFolder::remove_earlier() const {
  std::error_code left;  // a worker that was taken for lost may still write: the next turn removes its folder
  for (const int turn : turns_beside(sample_))
    if (turn < turn_) fs::remove_all(folder_of_turn(sample_, turn), left);
}

}  // namespace furnas
