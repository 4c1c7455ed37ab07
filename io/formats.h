#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "engine/state/packing.h"

namespace furnas {

/// A kind of file that holds a packing.
struct Format {
  std::string_view name;        ///< as in `export DIR NAME`
  std::string_view extensions;  ///< with dots, between blanks; the first is the usual one
  /// Whether the first bytes of a file tell that it is one; nothing if they never do.
  bool (*begins)(std::string_view head);
  /// Nothing if the format is only written.
  Packing (*read)(const std::filesystem::path& path);
  /// Nothing if the format is only read.
  void (*write)(const Packing& packing, const std::filesystem::path& path);
};

/// All formats.
std::span<const Format> formats();

/// Names, between commas, of the formats that can be written, or that can be read.
std::string names_of_written_formats();
std::string names_of_read_formats();

/// The format to write for the extension of a path; throws InputError for an unknown one.
std::string_view format_by_extension(const std::filesystem::path& path);

/// Reads a packing from a file of any format: its first bytes decide, then its extension. Throws InputError.
Packing read_packing(const std::filesystem::path& path);

/// Writes a packing in the format of this name; throws InputError for an unknown name, OutputError otherwise.
void write_packing(const Packing& packing, std::string_view format, const std::filesystem::path& path);

/// The usual extension of the format of this name, with its dot; throws InputError for an unknown name.
std::string_view extension_of(std::string_view format);

}  // namespace furnas
