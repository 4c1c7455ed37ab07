#include "cases/program/census.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/sphere.h"
#include "io/case_protocol.h"

namespace furnas {
namespace {

Census::Kind kind_of(const char* name, double count, double diameter, double exponent) {
  return {name, count, diameter, sphere_mass(0.5) * std::pow(diameter, exponent)};
}

Census census_of_mixture(const Case& c) {
  const double smalls = small_count(mixture_of(c)), larges = static_cast<double>(c.mixture.large);
  const double exponent = c.compaction.mass_exponent, ratio = large_diameter(mixture_of(c));
  Census n;
  if (smalls > 0) n.kinds.push_back(kind_of("small", smalls, 1, exponent));
  n.kinds.push_back(kind_of("large", larges, ratio, exponent));
  n.particles = smalls + larges;
  n.volume = larges * sphere_volume(0.5 * ratio) + smalls * sphere_volume(0.5);
  n.sizes = {ratio > 1 ? n.kinds.size() : 1, n.kinds.front().diameter, ratio};
  const double other = n.kinds.front().count > 1 ? n.kinds.front().mass : n.kinds.back().mass;
  n.lightest = {n.kinds.front().mass, other};
  n.density = {n.kinds.back().mass / sphere_mass(0.5 * ratio), 1};
  if (smalls == 0) n.density[1] = n.density[0];
  return n;
}

/// Adds a kind for all spheres for which `counts` is true. The smallest of them, or with `largest` the
/// largest, represents all.
template <class Counts>
void add_kind(Census& n, const Packing& p, const char* name, bool largest, Counts&& counts) {
  Census::Kind kind{name, 0, 0, INFINITY};
  double radius = largest ? 0 : INFINITY;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (!counts(k)) continue;
    ++kind.count;
    radius = largest ? std::max(radius, p.radius[k]) : std::min(radius, p.radius[k]);
  }
  if (kind.count == 0) return;
  kind.diameter = 2 * radius;
  for (std::size_t k = 0; k < p.size(); ++k)
    if (counts(k) && (!n.polydisperse || p.radius[k] == radius)) kind.mass = std::min(kind.mass, p.mass[k]);
  n.kinds.push_back(kind);
}

Census census_of_file(const Case& c) {
  const Packing p = start_of(c);
  Census n;
  n.particles = static_cast<double>(p.size());
  n.volume = p.sphere_volume();
  n.sizes = sizes_of(p.radius);
  n.polydisperse = is_one_polydisperse_species(p);
  if (n.polydisperse) {
    add_kind(n, p, "smallest", false, [](std::size_t) { return true; });
    add_kind(n, p, "largest", true, [](std::size_t) { return true; });
  } else {
    add_kind(n, p, "small", false, [&](std::size_t k) { return p.species[k] == Species::small; });
    add_kind(n, p, "large", true, [&](std::size_t k) { return p.species[k] == Species::large; });
  }
  std::vector<double> mass = p.mass;
  std::nth_element(mass.begin(), mass.begin() + (mass.size() > 1 ? 1 : 0), mass.end());
  n.lightest = {mass[0], mass.size() > 1 ? mass[1] : mass[0]};
  n.density = {INFINITY, 0};
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double density = p.mass[k] / sphere_mass(p.radius[k]);
    n.density = {std::min(n.density[0], density), std::max(n.density[1], density)};
  }
  return n;
}

}  // namespace

Census census_of(const Case& c) {
  return c.start.file.empty() && c.mixture.diameters.empty() ? census_of_mixture(c) : census_of_file(c);
}

std::string text_of(const Census& n) {
  std::string text;
  if (n.polydisperse) {
    text = fmt::format("particles {:.0f}: {} sizes from {:g} to {:g} (polydisperse)\n", n.particles,
                       n.sizes.count, n.sizes.smallest, n.sizes.largest);
  } else {
    const auto of = [&](const char* name) {
      const auto found = std::find_if(n.kinds.begin(), n.kinds.end(),
                                      [&](const Census::Kind& kind) { return kind.name == name; });
      return found == n.kinds.end() ? Census::Kind{name, 0, 1, 0} : *found;
    };
    text = fmt::format("particles {:.0f}: {:.0f} large of diameter {:g}, {:.0f} small of diameter {:g}\n",
                       n.particles, of("large").count, of("large").diameter, of("small").count,
                       of("small").diameter);
    if (n.kinds.size() == 2 && n.sizes.smallest == n.sizes.largest)
      text += "          all equal: with a size ratio of 1 large and small differ in name alone\n";
  }
  const auto is_usual = [](double density) { return std::abs(density - 1) < 1e-6; };
  if (!is_usual(n.density[0]) || !is_usual(n.density[1]))
    text +=
        fmt::format("density   {:.4g}{}\n", n.density[0],
                    n.density[1] > n.density[0] * (1 + 1e-6) ? fmt::format(" to {:.4g}", n.density[1]) : "");
  return text;
}

std::string refusal_of_units(const Census& n, const Case& c) {
  constexpr double rounding = 1e-3;  // of numbers in a text file
  if (c.start.file.empty() || std::abs(n.sizes.smallest - 1) < rounding) return {};
  return fmt::format(
      "lengths are in d_s, the diameter of the smallest spheres, and masses in rho d_s^3; the smallest "
      "sphere of "
      "{} has the diameter {:g} and the density {:.6g}. Rescale it: furnas import {} --scale {:.10g} "
      "--density {:.6g} --out start.vtp",
      c.start.file, n.sizes.smallest, n.density[0], c.start.file, 1 / n.sizes.smallest, n.density[0]);
}

}  // namespace furnas
