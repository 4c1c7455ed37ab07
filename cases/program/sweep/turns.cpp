#include "cases/program/sweep/turns.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include "cases/program/run/run_folder.h"
#include "cases/program/sweep/small_file.h"
#include "engine/base/numbers.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Kind = TurnRecord::Kind;

constexpr std::pair<Kind, const char*> kind_words[] = {
    {Kind::taken, "taken"}, {Kind::left, "left"}, {Kind::done, "done"}};

std::string text_of(const TurnRecord& record) {
  const char* word = "";
  for (const auto& [kind, name] : kind_words)
    if (kind == record.kind) word = name;
  return fmt::format("{} {} {}\n", word, record.worker, record.code);
}

/// A record that cannot be read counts as taken; on a file system without links, another worker may just be
/// writing it.
TurnRecord read_record(const fs::path& path, int number) {
  TurnRecord record{number, Kind::taken, "", 0};
  std::string word;
  std::ifstream file(path);
  if (!(file >> word >> record.worker >> record.code)) return {number, Kind::taken, "", 0};
  for (const auto& [kind, name] : kind_words)
    if (word == name) record.kind = kind;
  return record;
}

bool has_no_links(int error) {
  return error == EPERM || error == ENOTSUP || error == ENOSYS || error == EXDEV || error == EMLINK;
}

}  // namespace

Turns::Turns(fs::path sweep, const Worker& worker) : folder_(std::move(sweep) / "turns"), worker_(worker) {
  make_folder(folder_);
  look();
  for (const auto& [sample, record] : last_) at_begin_[sample] = record.number;
}

fs::path Turns::file(const std::string& sample, int number) const {
  return folder_ / fmt::format("{}.{}", sample, number);
}

std::string Turns::key_of(const fs::path& sample) const {
  std::string key;
  for (const fs::path& part : sample.lexically_relative(folder_.parent_path()))
    key += (key.empty() ? "" : "~") + part.string();
  return key;
}

void Turns::look() {
  std::map<std::string, int> newest;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    const auto dot = name.rfind('.');
    if (dot == std::string::npos) continue;
    if (const auto number = number_in<int>(name.substr(dot + 1))) {
      int& most = newest[name.substr(0, dot)];
      most = std::max(most, *number);
    }
  }
  for (const auto& [sample, number] : newest) {
    TurnRecord& known = last_[sample];
    if (known.number < number || known.worker.empty()) known = read_record(file(sample, number), number);
  }
}

TurnRecord Turns::last(const std::string& sample) const {
  const auto found = last_.find(sample);
  return found == last_.end() ? TurnRecord{} : found->second;
}

bool Turns::is_old(const std::string& sample) const {
  const auto found = at_begin_.find(sample);
  return found != at_begin_.end() && last(sample).number <= found->second;
}

/// If several workers write a record with the same number, one succeeds.
bool Turns::write(const std::string& sample, const TurnRecord& record) {
  const fs::path place = file(sample, record.number), own = worker_.own_file("record");
  const std::string text = text_of(record);
  require_written(own, write_small_file(own, text, O_TRUNC));
  int error = ::link(own.c_str(), place.c_str()) == 0 ? 0 : errno;
  if (has_no_links(error)) error = write_small_file(place, text, O_EXCL);
  // If the answer of the server is lost, NFS repeats the request and learns that the name exists: because of
  // this very link. In that case the file has two links.
  struct stat status {};
  if (error != 0 && ::stat(own.c_str(), &status) == 0 && status.st_nlink == 2) error = 0;
  ::unlink(own.c_str());
  if (error == EEXIST) return false;
  require_written(place, error);
  last_[sample] = record;
  return true;
}

std::optional<int> Turns::take(const std::string& sample) {
  const int number = last(sample).number + 1;
  if (!write(sample, {number, Kind::taken, worker_.name(), 0})) return {};
  return number;
}

bool Turns::end(const std::string& sample, int turn, Kind kind, int code) {
  return write(sample, {turn + 1, kind, worker_.name(), code});
}

bool Turns::lost(const std::string& sample, int turn) const {
  return ::access(file(sample, turn + 1).c_str(), F_OK) == 0;
}

}  // namespace furnas
