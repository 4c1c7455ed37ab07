#include "io/manifest.h"

#include <dirent.h>
#include <fmt/format.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/base/hasher.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "io/json_text.h"
#include "io/text_reader.h"

namespace furnas {
namespace fs = std::filesystem;

namespace {

/// Calls `visit` with the path of each regular file in the folder and the folders in it. The standard
/// library's iterators are not used, because they end the process when they get no memory.
template <class Visit>
void each_file(const fs::path& folder, Visit&& visit) {
  const std::unique_ptr<DIR, int (*)(DIR*)> directory(::opendir(folder.c_str()), ::closedir);
  if (!directory) throw fs::filesystem_error("cannot list", folder, {errno, std::generic_category()});
  for (;;) {
    errno = 0;  // readdir returns null at the end and on an error
    const dirent* const entry = ::readdir(directory.get());
    if (!entry && errno != 0)
      throw fs::filesystem_error("cannot list", folder, {errno, std::generic_category()});
    if (!entry) return;
    const std::string name = entry->d_name;
    if (name == "." || name == "..") continue;
    const fs::path path = folder / name;
    const fs::file_status status = fs::symlink_status(path);
    if (fs::is_directory(status)) each_file(path, visit);
    if (fs::is_regular_file(status)) visit(path);
  }
}

}  // namespace

void write_manifest(const fs::path& folder, const std::string& program) {
  constexpr const char* name = "manifest.json";
  std::map<std::string, nlohmann::ordered_json> files;
  each_file(folder, [&](const fs::path& path) {
    if (path.filename() == name || path.extension() == ".lock") return;
    std::ifstream in = open_file(path);
    std::uint64_t bytes = 0;
    Hasher hasher;
    read_in_parts(in, path, [&](std::string_view part) {
      hasher.add_bytes(part.data(), part.size());
      bytes += part.size();
    });
    files[path.lexically_relative(folder).string()] = {{"bytes", bytes},
                                                       {"xxh3", fmt::format("{:016x}", hasher.value())}};
  });
  write_file(folder / name, json_text({{"program", program}, {"files", files}}));
}

}  // namespace furnas
