#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/state/packing.h"
#include "viz/spheres.h"

namespace furnas {

/// What the colour of a particle says.
enum class Colouring {
  species,       ///< large grey, small gold; where a species has several sizes, the diameter
  coordination,  ///< how many contacts it has
  rattlers,      ///< whether it is one
  pressure       ///< what its contacts press on it, against the mean
};

/// Values from low to high, graded from dark blue to yellow.
struct ColourScale {
  double low{}, high{};
  bool logarithmic = false;
};

/// What the colours of a picture mean, to be drawn beside it: a scale, or a word for each colour.
struct ColourKey {
  struct Word {
    Rgb colour{};
    std::string text;
  };
  std::string title{};
  std::optional<ColourScale> scale{};
  std::vector<Word> words{};
};

/// A colour for each particle, and what the colours mean.
struct Coloured {
  std::vector<Rgb> particles;
  std::string key;   ///< for the reader of the picture, in a sentence
  ColourKey legend;  ///< the same, to be drawn
};

/// Colours the particles; those with fewer live contacts than `backbone_threshold` are rattlers.
Coloured coloured(const Packing& packing, Colouring colouring, int backbone_threshold);

/// From dark blue at 0 over green to yellow at 1, told apart in grey, too; values beyond are as at the ends.
Rgb graded(double value);

}  // namespace furnas
