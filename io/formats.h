#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/state/packing.h"

namespace furnas {

/// Which quantities a format can store, besides ids, types, radii, masses, positions, velocities and spins.
/// Only a checkpoint can store contacts with their histories.
struct Places {
  bool cell{};    ///< and image flags, and the step
  bool time{};    ///< of the packing
  bool forces{};  ///< and torques
  bool rate{};    ///< strain rate of the cell
  bool names{};   ///< of types
};

/// A format of files with a packing.
struct Format {
  std::string_view name;        ///< as in `export DIR NAME`
  std::string_view extensions;  ///< with dots, between blanks; the first is the usual one
  Places has;
  /// Whether the first bytes show that a file has this format; null if they never do.
  bool (*begins)(std::string_view head);
  /// Null if the format is only written.
  Packing (*read)(const std::filesystem::path& path);
  /// The frame of this number, counted from 1, or the last; null if such a file contains one packing.
  Packing (*read_frame)(const std::filesystem::path& path, std::optional<std::int64_t> frame);
  /// Null if the format is only read.
  void (*write)(const Packing& packing, const std::filesystem::path& path);
};

/// All formats.
std::span<const Format> formats();

/// Names, between commas, of the formats that can be written, or that can be read.
std::string names_of_written_formats();
std::string names_of_read_formats();

/// The format to write for the extension of a path; throws InputError for an unknown one.
std::string_view format_by_extension(const std::filesystem::path& path);

/// Reads a packing from a file of any format. The first bytes of the file determine the format; if they do
/// not, its extension does. From several frames it takes the one of this number, counted from 1, or the last.
/// Throws InputError.
Packing read_packing(const std::filesystem::path& path, std::optional<std::int64_t> frame = {});

/// Writes a packing in the format of this name; throws InputError for an unknown name, OutputError otherwise.
void write_packing(const Packing& packing, std::string_view format, const std::filesystem::path& path);

/// Lists, in words, the data of a packing that the format of this name cannot store; empty if it stores all.
/// Throws InputError for an unknown name.
std::string lost_in(const Packing& packing, std::string_view format);

/// The usual extension of the format of this name, with its dot; throws InputError for an unknown name.
std::string_view extension_of(std::string_view format);

}  // namespace furnas
