#include "tests/fuzz/targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "engine/base/require.h"
#include "engine/state/validate.h"
#include "io/append_file.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/checkpoint.h"
#include "io/extended_xyz.h"
#include "io/frames_pvd.h"
#include "io/lammps_data.h"
#include "io/lammps_dump.h"
#include "io/vtp_packing.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// A file that is in memory only.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written <= 0) throw std::runtime_error("no memory for a file");
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  fs::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// Reads the bytes as a file; a packing that comes out is a packing.
template <Packing (*read)(const fs::path&)>
void parse_packing(std::string_view bytes) {
  const MemoryFile file(bytes);
  try {
    const Packing packing = read(file.path());
    require(packing.size() > 0, "a packing that is read has particles");
    validate(packing);
  } catch (const InputError&) {
  }
}

Packing last_lammps_frame(const fs::path& path) { return read_lammps_frame(path); }

Packing last_xyz_frame(const fs::path& path) { return read_extended_xyz(path); }

Packing checkpointed(const fs::path& path) { return read_checkpoint(path).packing; }

/// A case that is read is written as a text that reads as the same case.
void parse_case_file(std::string_view bytes) {
  Case c;
  try {
    c = parse_case(bytes, "fuzz.toml");
    validate(c);
  } catch (const InputError&) {
    return;
  }
  require(parse_case(resolved_toml(c), "again.toml") == c, "a case is the same when it is written and read");
}

void parse_frames(std::string_view bytes) {
  const MemoryFile file(bytes);
  try {
    static_cast<void>(read_frames(file.path()));
  } catch (const InputError&) {
  }
}

void parse_override(std::string_view bytes) {
  Case c;
  try {
    apply_override(c, bytes);
  } catch (const InputError&) {
  }
}

// clang-format off
constexpr FuzzTarget table[] = {
    {"case",         parse_case_file},
    {"override",     parse_override},
    {"lammps-data",  parse_packing<read_lammps_data>},
    {"lammps-dump",  parse_packing<last_lammps_frame>},
    {"extxyz",       parse_packing<last_xyz_frame>},
    {"vtp",          parse_packing<read_vtp>},
    {"checkpoint",   parse_packing<checkpointed>},
    {"frames",       parse_frames},
};
// clang-format on

}  // namespace

std::span<const FuzzTarget> fuzz_targets() { return table; }

const FuzzTarget& fuzz_target(std::string_view name) {
  for (const FuzzTarget& target : table)
    if (target.name == name) return target;
  throw ContractError("there is no target " + std::string(name));
}

}  // namespace furnas
