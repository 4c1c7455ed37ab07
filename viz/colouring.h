#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/state/packing.h"
#include "viz/spheres.h"

namespace furnas {

/// The quantity that the colour of a particle shows.
enum class Colouring {
  species,       ///< large grey, small gold; where a species has several sizes, the diameter
  coordination,  ///< number of contacts of the particle
  rattlers,      ///< whether the particle is a rattler
  pressure       ///< pressure of its contacts, relative to the mean
};

/// Values from low to high, graded from dark blue to yellow.
struct ColourScale {
  double low{}, high{};
  bool logarithmic = false;
};

/// The legend of the colours of a picture: a scale, or a word for each colour.
struct ColourKey {
  struct Word {
    Rgb colour{};
    std::string text;
  };
  std::string title{};
  std::optional<ColourScale> scale{};
  std::vector<Word> words{};
};

/// A colour for each particle, and the meaning of the colours.
struct Coloured {
  std::vector<Rgb> particles;
  std::string key;   ///< the meaning of the colours in a sentence
  ColourKey legend;  ///< the same as a drawing
};

/// Colours the particles; those with fewer live contacts than `backbone_threshold` are rattlers.
Coloured coloured(const Packing& packing, Colouring colouring, int backbone_threshold);

/// The colour of a value: dark blue at 0, over green, to yellow at 1. The brightness rises with the value, so
/// that colours can be distinguished in grey. Values below 0 and above 1 have the colours of the ends.
Rgb graded(double value);

}  // namespace furnas
