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

/// What of a packing is drawn.
enum class PictureStyle {
  block,  ///< a solid block of spheres
  chains  ///< the contacts as tubes, thick and bright where they press, in translucent spheres
};

/// How a packing is drawn.
struct PictureOptions {
  int width = 2000;               ///< [pixels]
  int height = 2000;              ///< [pixels]
  bool transparent = false;       ///< no background instead of a white one
  bool cell = true;               ///< draw the edges of the periodic cell
  bool key = false;               ///< say below the packing what the colours mean, where there is room
  bool ambient_occlusion = true;  ///< darken what lies deep between spheres
  PictureStyle style = PictureStyle::block;
  Colouring colouring = Colouring::species;
  int backbone_threshold = 4;         ///< live contacts below which a particle is a rattler
  std::array<int, 3> times{1, 1, 1};  ///< how often the cell is repeated along its edges; block alone
  std::optional<Slice> slice{};       ///< the part that is drawn; all if absent
  double turn = 0;                    ///< of the eye about the vertical, from the usual view [degrees]
  double room = 0;  ///< the frame holds a ball of this radius about the middle, which stays as the block
                    ///< turns or shrinks [d_s]; 0: what is drawn fills it
};

/// The packing in three-quarter view: every particle once, at its place in the cell. Needs no display. Throws
/// InputError when there is no particle, no OpenGL or no such size, or chains are asked of a packing without
/// contacts.
Pixels render(const Packing& packing, const PictureOptions& options = {});

/// render, to a PNG or JPEG file (write_picture); throws OutputError when the file cannot be written.
void render_picture(const Packing& packing, const std::filesystem::path& path,
                    const PictureOptions& options = {});

/// Radius of the ball that holds everything, the cell repeated `times`, about the middle of it all [d_s]; for
/// PictureOptions::room.
double room_of(const Packing& packing, const std::array<int, 3>& times = {1, 1, 1});

/// What the colours mean, for the reader.
std::string key_of(const Packing& packing, const PictureOptions& options);

}  // namespace furnas
