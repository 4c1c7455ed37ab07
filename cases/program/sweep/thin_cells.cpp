#include "cases/program/sweep/thin_cells.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "io/case_protocol.h"
#include "io/result.h"

namespace furnas {

double dense_thickness(const Case& c) {
  if (!c.start.file.empty() || !c.mixture.diameters.empty()) return std::numeric_limits<double>::infinity();
  constexpr double dense = 0.64;
  const Mixture mixture = mixture_of(c);
  const double spheres =
      static_cast<double>(mixture.large) * std::pow(mixture.size_ratio, 3) + small_count(mixture);
  return std::cbrt(std::numbers::pi / 6 * spheres / dense) / mixture.size_ratio;
}

std::string remark_on_thin_cells(const std::vector<Sample>& samples) {
  std::map<std::filesystem::path, const Sample*> points;
  for (const Sample& sample : samples) points.emplace(sample.folder.parent_path(), &sample);
  std::size_t thin = 0;
  double thinnest = least_thickness, wanted = 0;
  for (const auto& [folder, sample] : points) {
    const Case& c = sample->resolved_case;
    const double thickness = dense_thickness(c);
    if (thickness >= least_thickness) continue;
    ++thin;
    thinnest = std::min(thinnest, thickness);
    wanted = std::max(
        wanted, std::ceil(static_cast<double>(c.mixture.large) * std::pow(least_thickness / thickness, 3)));
  }
  if (thin == 0) return {};
  return fmt::format(
      "cells     of {} of {} points too thin to stand for a large packing, down to {:.1f} largest diameters "
      "when dense; mixture.large = {:.0f} makes all {:g} wide\n",
      thin, points.size(), thinnest, wanted, least_thickness);
}

}  // namespace furnas
