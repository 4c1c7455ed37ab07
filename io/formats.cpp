#include "io/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/require.h"
#include "io/checkpoint.h"
#include "io/extended_xyz.h"
#include "io/lammps_data.h"
#include "io/lammps_dump.h"
#include "io/packing_csv.h"
#include "io/text_reader.h"
#include "io/vtp_packing.h"

namespace furnas {
namespace {

bool begins_checkpoint(std::string_view head) { return head.starts_with(checkpoint_magic); }
bool begins_dump(std::string_view head) { return head.starts_with("ITEM: "); }
bool begins_xyz(std::string_view head) { return head.find("Lattice=") != head.npos; }
bool begins_data(std::string_view head) {
  return head.find(" atoms") != head.npos && head.find("xlo xhi") != head.npos;
}
bool begins_vtp(std::string_view head) {
  return head.find("<VTKFile") != head.npos && head.find("PolyData") != head.npos;
}

Packing read_checkpointed_packing(const std::filesystem::path& path) { return read_checkpoint(path).packing; }

// A new format is one line.
constexpr std::array<Format, 6> all{{
    {"checkpoint", ".checkpoint", begins_checkpoint, read_checkpointed_packing, nullptr},
    {"lammps-data", ".data .lmp", begins_data, read_lammps_data, write_lammps_data},
    {"lammps-dump", ".lammpstrj .dump", begins_dump, read_last_lammps_frame, write_lammps_dump},
    {"extxyz", ".extxyz .xyz", begins_xyz, read_extended_xyz, write_extended_xyz},
    {"vtp", ".vtp", begins_vtp, read_vtp, write_vtp},
    {"csv", ".csv", nullptr, nullptr, write_packing_csv},
}};

/// The first bytes of a file.
std::string head_of(const std::filesystem::path& path) {
  constexpr std::uint64_t most = 4096;
  std::string head(static_cast<std::size_t>(std::min(readable_size(path), most)), '\0');
  open_file(path).read(head.data(), static_cast<std::streamsize>(head.size()));
  return head;
}

bool has_extension(const Format& format, const std::string& extension) {
  const std::string list = fmt::format(" {} ", format.extensions);
  return !extension.empty() && list.find(" " + extension + " ") != std::string::npos;
}

/// "lammps-data (.data .lmp), ..." of the formats that `has`.
template <class Has>
std::string listed(Has has) {
  std::string text;
  for (const Format& format : all)
    if (has(format))
      text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", format.name, format.extensions);
  return text;
}

/// The names alone.
template <class Has>
std::string names(Has has) {
  std::string text;
  for (const Format& format : all)
    if (has(format)) text += fmt::format("{}{}", text.empty() ? "" : ", ", format.name);
  return text;
}

const Format& writable(std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Format& f) { return f.name == name && f.write; });
  if (found == all.end())
    throw InputError(fmt::format("'{}' is no format to write; allowed are {}", name,
                                 listed([](const Format& f) { return f.write != nullptr; })));
  return *found;
}

}  // namespace

std::span<const Format> formats() { return all; }

std::string names_of_written_formats() {
  return names([](const Format& f) { return f.write != nullptr; });
}

std::string names_of_read_formats() {
  return names([](const Format& f) { return f.read != nullptr; });
}

std::string_view format_by_extension(const std::filesystem::path& path) {
  for (const Format& format : all)
    if (format.write && has_extension(format, path.extension().string())) return format.name;
  throw InputError(fmt::format("{}: its extension tells no format to write; allowed are {}", path.string(),
                               listed([](const Format& f) { return f.write != nullptr; })));
}

Packing read_packing(const std::filesystem::path& path) {
  const std::string head = head_of(path), extension = path.extension().string();
  for (const Format& format : all)
    if (format.read && format.begins && format.begins(head)) return format.read(path);
  for (const Format& format : all)
    if (format.read && has_extension(format, extension)) return format.read(path);
  throw InputError(fmt::format("{}: neither its content nor its extension tells the format; allowed are {}",
                               path.string(), listed([](const Format& f) { return f.read != nullptr; })));
}

void write_packing(const Packing& packing, std::string_view format, const std::filesystem::path& path) {
  writable(format).write(packing, path);
}

std::string_view extension_of(std::string_view format) {
  const std::string_view list = writable(format).extensions;
  return list.substr(0, list.find(' '));
}

}  // namespace furnas
