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
  return head.find(" atoms") != head.npos &&
         (head.find("xlo xhi") != head.npos || head.find("avec") != head.npos);
}
bool begins_vtp(std::string_view head) {
  return head.find("<VTKFile") != head.npos && head.find("PolyData") != head.npos;
}

Packing read_checkpointed_packing(const std::filesystem::path& path) { return read_checkpoint(path).packing; }

// A new format needs one more line here.
// clang-format off
constexpr std::array<Format, 6> all{{
    {"checkpoint", ".checkpoint", {.cell = true, .time = true, .forces = true, .rate = true, .names = true},
     begins_checkpoint, read_checkpointed_packing, nullptr, nullptr},
    {"lammps-data", ".data .lmp", {.cell = true, .names = true},
     begins_data, read_lammps_data, nullptr, write_lammps_data},
    {"lammps-dump", ".lammpstrj .dump", {.cell = true, .time = true, .forces = true, .names = true},
     begins_dump, nullptr, read_lammps_frame, write_lammps_dump},
    {"extxyz", ".extxyz .xyz", {.cell = true, .time = true, .forces = true, .names = true},
     begins_xyz, nullptr, read_extended_xyz, write_extended_xyz},
    {"vtp", ".vtp", {.cell = true, .time = true, .forces = true, .rate = true},
     begins_vtp, read_vtp, nullptr, write_vtp},
    {"csv", ".csv", {.forces = true, .names = true},
     nullptr, nullptr, nullptr, write_packing_csv},
}};
// clang-format on

bool is_read(const Format& f) { return f.read != nullptr || f.read_frame != nullptr; }

Packing read_as(const Format& format, const std::filesystem::path& path, std::optional<std::int64_t> frame) {
  if (format.read_frame) return format.read_frame(path, frame);
  if (frame && *frame != 1)
    throw InputError(fmt::format("{}: there is no frame {}: a file of the format {} contains one packing",
                                 path.string(), *frame, format.name));
  return format.read(path);
}

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

/// "lammps-data (.data .lmp), ...": the formats for which `has` is true, with their extensions.
template <class Has>
std::string listed(Has has) {
  std::string text;
  for (const Format& format : all)
    if (has(format))
      text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", format.name, format.extensions);
  return text;
}

/// The same without extensions.
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

std::string names_of_read_formats() { return names(is_read); }

std::string_view format_by_extension(const std::filesystem::path& path) {
  for (const Format& format : all)
    if (format.write && has_extension(format, path.extension().string())) return format.name;
  throw InputError(fmt::format("{}: its extension belongs to no format that can be written; allowed are {}",
                               path.string(), listed([](const Format& f) { return f.write != nullptr; })));
}

Packing read_packing(const std::filesystem::path& path, std::optional<std::int64_t> frame) {
  const std::string head = head_of(path), extension = path.extension().string();
  for (const Format& format : all)
    if (is_read(format) && format.begins && format.begins(head)) return read_as(format, path, frame);
  for (const Format& format : all)
    if (is_read(format) && has_extension(format, extension)) return read_as(format, path, frame);
  throw InputError(
      fmt::format("{}: neither its content nor its extension determines the format; allowed are {}",
                  path.string(), listed(is_read)));
}

void write_packing(const Packing& packing, std::string_view format, const std::filesystem::path& path) {
  writable(format).write(packing, path);
}

std::string lost_in(const Packing& p, std::string_view format) {
  const Places& has = writable(format).has;
  const auto any = [](const std::vector<Vec3<double>>& list) {
    return std::any_of(list.begin(), list.end(), [](const auto& v) { return v != Vec3<double>{}; });
  };
  std::vector<std::string> lost;
  if (!has.cell) lost.emplace_back("the cell, image flags and the step");
  if (!has.time && p.time != 0) lost.emplace_back("the time");
  if (!has.forces && (any(p.force) || any(p.torque))) lost.emplace_back("forces and torques");
  if (!p.contacts.empty()) lost.emplace_back("contacts with their histories");
  if (!has.rate && p.cell.rate != Triangle{}) lost.emplace_back("the strain rate of the cell");
  if (!has.names && !p.labels.names.empty()) lost.emplace_back("the names of types");
  return fmt::format("{}", fmt::join(lost, ", "));
}

std::string_view extension_of(std::string_view format) {
  const std::string_view list = writable(format).extensions;
  return list.substr(0, list.find(' '));
}

}  // namespace furnas
