#include "viz/colouring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analysis/contacts.h"
#include "engine/analysis/rattlers.h"
#include "engine/base/sphere.h"
#include "engine/state/species.h"
#include "viz/palette.h"

namespace furnas {
namespace {

Rgb rgb(const Colour& colour) {
  Rgb result;
  for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<std::uint8_t>(std::lround(255 * colour[c]));
  return result;
}

Coloured by_species(const Packing& packing) {
  Coloured result{{},
                  "large spheres grey, small ones gold",
                  {.words = {{rgb(large_colour), "large"}, {rgb(small_colour), "small"}}}};
  for (const Species species : packing.species) result.particles.push_back(rgb(colour_of(species)));
  return result;
}

/// Colours spheres of many sizes by diameter, from the smallest to the largest; on a logarithmic scale if
/// their ratio is above `wide`.
Coloured by_size(const Packing& packing) {
  const Sizes sizes = sizes_of(packing.radius);
  constexpr double wide = 5;  // with a larger ratio a linear scale leaves most spheres at one end
  const bool logarithmic = sizes.largest > wide * sizes.smallest;
  Coloured result{
      {},
      fmt::format("diameters from {:g} (dark blue) to {:g} (yellow)", sizes.smallest, sizes.largest),
      {.title = "diameter [d_s]", .scale = ColourScale{sizes.smallest, sizes.largest, logarithmic}}};
  const auto share = [&](double diameter) {
    return logarithmic ? std::log(diameter / sizes.smallest) / std::log(sizes.largest / sizes.smallest)
                       : (diameter - sizes.smallest) / (sizes.largest - sizes.smallest);
  };
  for (const double radius : packing.radius) result.particles.push_back(graded(share(2 * radius)));
  return result;
}

Coloured graded_by(const std::vector<double>& values, double most, const std::string& what) {
  Coloured result{
      {},
      fmt::format("{}, from 0 (dark blue) to {:g} (yellow)", what, most),
      {.title = fmt::format("{} ({:g} and more: yellow)", what, most), .scale = ColourScale{0, most}}};
  for (const double value : values) result.particles.push_back(graded(value / most));
  return result;
}

Coloured by_coordination(const Packing& packing) {
  std::vector<double> contacts(packing.size());
  for (const Contact& c : packing.contacts) ++contacts[c.i], ++contacts[c.j];
  // The scale ends at 12 contacts. A few large spheres may have thousands, and with a longer scale all others
  // would have the same colour.
  constexpr double most = 12;
  return graded_by(contacts, most, "contacts of a sphere");
}

Coloured by_rattlers(const Packing& packing, int threshold) {
  const std::vector<bool> out = rattlers(packing, live_contacts(packing), threshold);
  const bool told_apart = !is_one_polydisperse_species(packing);
  const auto colour = [&](bool rattles, Species species) {
    Colour c = rattles ? orange : blue;
    if (told_apart && species == Species::large)
      for (double& part : c) part = 0.5 + 0.5 * part;
    return rgb(c);
  };
  Coloured result{{},
                  fmt::format("rattlers (fewer than {} live contacts) orange, backbone blue{}", threshold,
                              told_apart ? "; large spheres paler" : ""),
                  {}};
  for (std::size_t k = 0; k < packing.size(); ++k)
    result.particles.push_back(colour(out[k], packing.species[k]));
  for (const Species species : {Species::large, Species::small}) {
    if (std::find(packing.species.begin(), packing.species.end(), species) == packing.species.end()) continue;
    const std::string name = !told_apart ? "" : species == Species::large ? "large, " : "small, ";
    result.legend.words.push_back({colour(false, species), name + "backbone"});
    result.legend.words.push_back({colour(true, species), name + "rattler"});
  }
  return result;
}

/// Colours by pressure: sum of normal force times radius, divided by three times the volume of the sphere,
/// relative to the same quantity of all spheres together.
Coloured by_pressure(const Packing& packing) {
  std::vector<double> pressure(packing.size());
  double virial = 0, volume = 0;
  for (const Contact& c : packing.contacts) {
    const double normal = normal_force(c);
    for (const std::uint32_t k : {c.i, c.j}) {
      virial += normal * packing.radius[k];
      pressure[k] += normal * packing.radius[k];
    }
  }
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double own = sphere_volume(packing.radius[k]);
    pressure[k] /= own;
    volume += own;
  }
  const double mean = virial / volume;
  if (mean > 0)
    for (double& p : pressure) p /= mean;
  constexpr double most = 3;
  return graded_by(pressure, most, "pressure on a sphere over that on all");
}

}  // namespace

Rgb graded(double value) {
  // The colour map "viridis" of Smith and van der Walt (2015, public domain), at every eighth of its range.
  constexpr std::array<Rgb, 9> stops{{{68, 1, 84},
                                      {71, 44, 122},
                                      {59, 81, 139},
                                      {44, 113, 142},
                                      {33, 144, 141},
                                      {39, 173, 129},
                                      {92, 200, 99},
                                      {170, 220, 50},
                                      {253, 231, 37}}};
  const double at = std::clamp(value, 0.0, 1.0) * (stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  Rgb result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = static_cast<std::uint8_t>(
        std::lround(std::lerp(double(stops[low][c]), double(stops[low + 1][c]), at - double(low))));
  return result;
}

Coloured coloured(const Packing& packing, Colouring colouring, int backbone_threshold) {
  switch (colouring) {
    case Colouring::species:
      return is_polydisperse(packing) ? by_size(packing) : by_species(packing);
    case Colouring::coordination:
      return by_coordination(packing);
    case Colouring::rattlers:
      return by_rattlers(packing, backbone_threshold);
    case Colouring::pressure:
      return by_pressure(packing);
  }
  return by_species(packing);
}

}  // namespace furnas
