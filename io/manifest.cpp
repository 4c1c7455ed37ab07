#include "io/manifest.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/base/hasher.h"
#include "io/atomic_file.h"

namespace furnas {
namespace fs = std::filesystem;

void write_manifest(const fs::path& folder, const std::string& program) {
  constexpr const char* name = "manifest.json";
  std::map<std::string, nlohmann::ordered_json> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (!entry.is_regular_file() || entry.path().filename() == name || extension == ".lock") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    Hasher hasher;
    hasher.add_bytes(bytes.data(), bytes.size());
    files[fs::relative(entry.path(), folder).string()] = {{"bytes", bytes.size()},
                                                          {"xxh3", fmt::format("{:016x}", hasher.value())}};
  }
  write_file(folder / name, nlohmann::ordered_json{{"program", program}, {"files", files}}.dump(2) + "\n");
}

}  // namespace furnas
