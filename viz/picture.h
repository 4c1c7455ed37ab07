#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/state/packing.h"
#include "viz/colouring.h"
#include "viz/pixels.h"
#include "viz/spheres.h"

namespace furnas {

/// Which part of a packing is drawn.
enum class PictureStyle {
  block,  ///< a solid block of spheres
  chains  ///< the contacts as tubes, thicker and brighter for larger forces, in translucent spheres
};

/// How a packing is drawn.
struct PictureOptions {
  int width = 2000;               ///< [pixels]
  int height = 2000;              ///< [pixels]
  bool transparent = false;       ///< no background instead of a white one
  bool cell = true;               ///< draw the edges of the periodic cell
  bool key = false;               ///< draw the legend of the colours below the packing, if there is room
  bool ambient_occlusion = true;  ///< darken surfaces deep between spheres
  PictureStyle style = PictureStyle::block;
  Colouring colouring = Colouring::species;
  int backbone_threshold = 4;         ///< live contacts below which a particle is a rattler
  std::array<int, 3> times{1, 1, 1};  ///< repetitions of the cell along its edges; only for `block`
  std::optional<Slice> slice{};       ///< the part that is drawn; everything if absent
  double turn = 0;  ///< rotation of the eye about the vertical, from the default view [degrees]
  double room = 0;  ///< the frame fits a ball of this radius about the middle, so that the scale stays the
                    ///< same in a series of pictures [d_s]; 0: the frame fits what is drawn
};

/// The packing in three-quarter view: every particle once, at its place in the cell. Needs no display. Throws
/// InputError when there is no particle or no OpenGL, when the size is not possible, or when chains are
/// requested for a packing without contacts.
Pixels render(const Packing& packing, const PictureOptions& options = {});

/// Renders to a PNG or JPEG file (write_picture); throws OutputError when the file cannot be written.
void render_picture(const Packing& packing, const std::filesystem::path& path,
                    const PictureOptions& options = {});

/// Radius of the ball about the middle that contains all spheres and the cell, repeated `times` [d_s]; for
/// PictureOptions::room.
double room_of(const Packing& packing, const std::array<int, 3>& times = {1, 1, 1});

/// A sentence about the meaning of the colours.
std::string key_of(const Packing& packing, const PictureOptions& options);

}  // namespace furnas
