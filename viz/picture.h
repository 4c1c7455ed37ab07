#pragma once

#include <filesystem>

#include "engine/state/packing.h"
#include "viz/pixels.h"

namespace furnas {

/// How a packing is drawn.
struct PictureOptions {
  int width = 2000;               ///< [pixels]
  int height = 2000;              ///< [pixels]
  bool transparent = false;       ///< no background instead of a white one
  bool cell = true;               ///< draw the edges of the periodic cell
  bool ambient_occlusion = true;  ///< darken what lies deep between spheres
};

/// The packing as a solid block in three-quarter view: every particle once, at its place in the cell.
/// Needs no display. Throws InputError when there is no particle, no OpenGL or no such size.
Pixels render(const Packing& packing, const PictureOptions& options = {});

/// render, to a PNG file; throws InputError also when the file cannot be written.
void render_png(const Packing& packing, const std::filesystem::path& path,
                const PictureOptions& options = {});

}  // namespace furnas
