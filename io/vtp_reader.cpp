#include "io/vtp_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "io/particle_rows.h"
#include "io/vtp_file.h"

namespace furnas {
namespace {

/// A number that must be whole and at most `limit` in size.
std::int64_t whole(const VtpFile& file, double value, double limit, const char* name) {
  if (!(std::abs(value) <= limit) || value != std::nearbyint(value))
    file.fail(fmt::format("{} is {}; expected a whole number within {}", name, value, limit));
  return static_cast<std::int64_t>(value);
}

/// A field array of nine numbers, row by row.
Triangle triangle(VtpFile& file, const char* name) {
  const std::vector<double> m = file.numbers("FieldData", name, 1, 9);
  if (m[3] != 0 || m[6] != 0 || m[7] != 0)
    file.fail(fmt::format("the field array {} must be an upper triangle, row by row", name));
  return {.xx = m[0], .yy = m[4], .zz = m[8], .yz = m[5], .xz = m[2], .xy = m[1]};
}

/// A point array of vectors; zeros if it is missing.
std::vector<Vec3<double>> vectors(VtpFile& file, const char* section, const char* name) {
  std::vector<Vec3<double>> values(static_cast<std::size_t>(file.points()));
  if (!file.has(section, name)) return values;
  const std::vector<double> numbers = file.numbers(section, name, file.points(), 3);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
  return values;
}

void read_field(VtpFile& file, Packing& packing) {
  const auto number = [&](const char* name) {
    return file.has("FieldData", name) ? file.numbers("FieldData", name, 1, 1)[0] : 0;
  };
  packing.cell.edges = triangle(file, "cell");
  if (file.has("FieldData", "rate")) packing.cell.rate = triangle(file, "rate");
  packing.time = number("TimeValue");
  packing.step = whole(file, number("step"), 9e15, "step");
}

void read_sizes(VtpFile& file, Packing& packing) {
  packing.radius = file.numbers("PointData", "radius", file.points(), 1);
  packing.resize(packing.radius.size());
  if (file.has("PointData", "mass")) {
    packing.mass = file.numbers("PointData", "mass", file.points(), 1);
  } else {
    for (std::size_t k = 0; k < packing.size(); ++k) packing.mass[k] = sphere_mass(packing.radius[k]);
  }
  packing.species = species_by_size(packing.radius);
  if (!file.has("PointData", "species")) return;
  const std::vector<double> species = file.numbers("PointData", "species", file.points(), 1);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    if (species[k] != 0 && species[k] != 1) file.fail("species must be 0 (large) or 1 (small)");
    packing.species[k] = species[k] == 0 ? Species::large : Species::small;
  }
}

void read_positions(VtpFile& file, Packing& packing) {
  const auto points = vectors(file, "Points", "Points"), image = vectors(file, "PointData", "image");
  const auto count = [&](double value) {
    return static_cast<std::int32_t>(whole(file, value, 1e9, "image"));
  };
  for (std::size_t k = 0; k < packing.size(); ++k) {
    packing.image[k] = {count(image[k].x), count(image[k].y), count(image[k].z)};
    if (!wrap(in_edges(packing.cell.edges, points[k]), packing.fraction[k], packing.image[k]))
      file.fail(fmt::format("particle {}: the position is not finite or too many cells away", k + 1));
  }
}

void check_order(VtpFile& file) {
  if (!file.has("PointData", "id")) return;
  const std::vector<double> id = file.numbers("PointData", "id", file.points(), 1);
  for (std::size_t k = 0; k < id.size(); ++k)
    if (id[k] != static_cast<double>(k + 1)) file.fail("the ids must be 1 2 3 ... in this order");
}

}  // namespace

Packing read_vtp(const std::filesystem::path& path) {
  VtpFile file(path);
  if (!file.has("FieldData", "cell") || !file.has("PointData", "radius") || !file.has("Points", "Points"))
    file.fail("the points, the field array cell (9 numbers) and the point array radius are needed");
  Packing packing;
  read_sizes(file, packing);
  read_field(file, packing);
  packing.velocity = vectors(file, "PointData", "velocity");
  packing.spin = vectors(file, "PointData", "spin");
  packing.force = vectors(file, "PointData", "force");
  packing.torque = vectors(file, "PointData", "torque");
  check_order(file);
  check_packing(packing, path);
  read_positions(file, packing);
  return packing;
}

}  // namespace furnas
