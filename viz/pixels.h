#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace furnas {

/// A picture, row by row from the bottom, with four bytes per pixel: red, green, blue, opacity (colours not
/// multiplied by opacity).
struct Pixels {
  int width{}, height{};           ///< [pixels]
  std::vector<std::uint8_t> rgba;  ///< 4 width height bytes
};

/// Throws InputError unless the extension of a file is that of a supported picture format: .png, or, without
/// opacity, .jpg or .jpeg.
void require_picture_file(const std::filesystem::path& path, bool opacity);

/// Writes a PNG or a JPEG file, depending on the extension; throws as write_png and require_picture_file do.
void write_picture(const Pixels& pixels, const std::filesystem::path& path, bool opacity);

/// Writes a PNG file, with opacity or opaque. The file is written completely or not at all; throws
/// OutputError when it cannot be written.
void write_png(const Pixels& pixels, const std::filesystem::path& path, bool opacity);

}  // namespace furnas
