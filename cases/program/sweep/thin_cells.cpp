#include "cases/program/sweep/thin_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "engine/protocol/protocol.h"
#include "io/case_protocol.h"
#include "io/diameters_file.h"
#include "io/result.h"

namespace furnas {

double thickness_in_diameters(const Case& c) {
  if (!c.start.file.empty()) return std::numeric_limits<double>::infinity();
  double volume = 0, largest = 1;  // volume of all spheres in units of d_s^3 pi/6; largest diameter [d_s]
  if (!c.mixture.diameters.empty()) {
    for (const double d : read_diameters(c.mixture.diameters).diameters) {
      volume += d * d * d;
      largest = std::max(largest, d);
    }
  } else {
    const Mixture mixture = mixture_of(c);
    largest = mixture.size_ratio;
    volume = static_cast<double>(mixture.large) * std::pow(largest, 3) + small_count(mixture);
  }
  return dense_thickness(std::numbers::pi / 6 * volume) / largest;
}

std::string remark_on_thin_cells(const std::vector<Sample>& samples) {
  std::map<std::filesystem::path, const Sample*> points;
  for (const Sample& sample : samples) points.emplace(sample.folder.parent_path(), &sample);
  std::size_t thin = 0;
  double thinnest = least_thickness, large = 0;
  for (const auto& [folder, sample] : points) {
    const Case& c = sample->resolved_case;
    const double thickness = thickness_in_diameters(c);
    if (thickness >= least_thickness) continue;
    ++thin;
    thinnest = std::min(thinnest, thickness);
    if (c.mixture.diameters.empty())
      large = std::max(
          large, std::ceil(static_cast<double>(c.mixture.large) * std::pow(least_thickness / thickness, 3)));
  }
  if (thin == 0) return {};
  const std::string remedy =
      large > 0 ? fmt::format("mixture.large = {:.0f} makes", large)
                : fmt::format("lists {:.1f} times as long make", std::pow(least_thickness / thinnest, 3));
  return fmt::format(
      "cells     at {} of {} points are too thin to represent a large packing, down to {} largest "
      "diameters "
      "when dense; {} all of them {:g} thick\n",
      thin, points.size(), thickness_text(thinnest), remedy, least_thickness);
}

}  // namespace furnas
