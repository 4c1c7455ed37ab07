#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace furnas {

/// A picture, row by row from the bottom, four bytes each: red, green, blue, opacity (not multiplied in).
struct Pixels {
  int width{}, height{};           ///< [pixels]
  std::vector<std::uint8_t> rgba;  ///< 4 width height bytes
};

/// Throws InputError unless the extension of a file names a format of pictures that can be written: .png, or
/// .jpg and .jpeg, which know no opacity.
void require_picture_file(const std::filesystem::path& path, bool opacity);

/// Writes a PNG or a JPEG file, whichever its extension names; as write_png and require_picture_file.
void write_picture(const Pixels& pixels, const std::filesystem::path& path, bool opacity);

/// Writes a PNG file, with opacity or opaque. The file appears whole or not at all; throws OutputError
/// when it cannot be written.
void write_png(const Pixels& pixels, const std::filesystem::path& path, bool opacity);

}  // namespace furnas
