#include "io/vtp_packing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/particle_rows.h"
#include "io/species_type.h"
#include "io/vtp_reader.h"
#include "io/vtp_writer.h"

namespace furnas {
namespace {

std::array<double, 9> matrix(const Triangle& h) { return {h.xx, h.xy, h.xz, 0, h.yy, h.yz, 0, 0, h.zz}; }

std::vector<std::int32_t> coordination(const Packing& packing) {
  std::vector<std::int32_t> count(packing.size());
  for (const Contact& c : packing.contacts) ++count[c.i], ++count[c.j];
  return count;
}

/// From the centre of j to that of i, of length 1; zero if they coincide.
Vec3<double> direction(const Contact& c) {
  const double length = norm(c.branch);
  return length > 0 ? c.branch * (1 / length) : Vec3<double>{};
}

double normal_force(const Contact& c) { return dot(c.force, direction(c)); }

double tangential_force(const Contact& c) { return norm(c.force - direction(c) * normal_force(c)); }

/// The ends of the twelve edges of the cell, two by two.
std::vector<Vec3<double>> ends_of_edges(const Cell& cell) {
  std::vector<Vec3<double>> points;
  for (unsigned from = 0; from < 8; ++from)
    for (unsigned axis = 1; axis < 8; axis *= 2)
      if (!(from & axis))
        for (const unsigned corner : {from, from | axis})
          points.push_back(cell.edges * Vec3<double>{corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0,
                                                     corner & 4 ? 1.0 : 0.0});
  return points;
}

/// A number that must be whole and at most `limit` in size.
std::int64_t whole(const VtpReader& file, double value, double limit, const char* name) {
  if (!(std::abs(value) <= limit) || value != std::nearbyint(value))
    file.fail(fmt::format("{} is {}; expected a whole number within {}", name, value, limit));
  return static_cast<std::int64_t>(value);
}

/// A field array of nine numbers, row by row.
Triangle triangle(VtpReader& file, const char* name) {
  const std::vector<double> m = file.numbers("FieldData", name, 1, 9);
  if (m[3] != 0 || m[6] != 0 || m[7] != 0)
    file.fail(fmt::format("the field array {} must be an upper triangle, row by row", name));
  return {.xx = m[0], .yy = m[4], .zz = m[8], .yz = m[5], .xz = m[2], .xy = m[1]};
}

/// A point array of vectors; zeros if it is missing.
std::vector<Vec3<double>> vectors(VtpReader& file, const char* section, const char* name) {
  std::vector<Vec3<double>> values(static_cast<std::size_t>(file.points()));
  if (!file.has(section, name)) return values;
  const std::vector<double> numbers = file.numbers(section, name, file.points(), 3);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
  return values;
}

void read_field(VtpReader& file, Packing& packing) {
  const auto number = [&](const char* name) {
    return file.has("FieldData", name) ? file.numbers("FieldData", name, 1, 1)[0] : 0;
  };
  packing.cell.edges = triangle(file, "cell");
  if (file.has("FieldData", "rate")) packing.cell.rate = triangle(file, "rate");
  if (file.has("FieldData", "origin")) {
    const std::vector<double> corner = file.numbers("FieldData", "origin", 1, 3);
    packing.labels.origin = {corner[0], corner[1], corner[2]};
  }
  packing.time = number("TimeValue");
  packing.step = whole(file, number("step"), 9e15, "step");
}

void read_sizes(VtpReader& file, Packing& packing) {
  packing.radius = file.numbers("PointData", "radius", file.points(), 1);
  packing.resize(packing.radius.size());
  if (file.has("PointData", "mass")) {
    packing.mass = file.numbers("PointData", "mass", file.points(), 1);
  } else {
    for (std::size_t k = 0; k < packing.size(); ++k) packing.mass[k] = sphere_mass(packing.radius[k]);
  }
}

void read_species(VtpReader& file, Packing& packing) {
  std::vector<std::int32_t> types;
  if (file.has("PointData", "type"))
    for (const double type : file.numbers("PointData", "type", file.points(), 1)) {
      types.push_back(static_cast<std::int32_t>(whole(file, type, most_types, "type")));
      if (types.back() < 1) file.fail("the type must be 1 or more");
    }
  if (!file.has("PointData", "species")) return label_by_types(packing, std::move(types), {});
  const std::vector<double> species = file.numbers("PointData", "species", file.points(), 1);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    if (species[k] != 0 && species[k] != 1) file.fail("species must be 0 (large) or 1 (small)");
    packing.species[k] = species[k] == 0 ? Species::large : Species::small;
  }
  keep_types(packing, std::move(types), {});
}

void read_positions(VtpReader& file, Packing& packing) {
  const auto points = vectors(file, "Points", "Points"), image = vectors(file, "PointData", "image");
  const auto count = [&](double value) {
    return static_cast<std::int32_t>(whole(file, value, 1e9, "image"));
  };
  for (std::size_t k = 0; k < packing.size(); ++k) {
    packing.image[k] = {count(image[k].x), count(image[k].y), count(image[k].z)};
    if (!wrap(in_edges(packing.cell.edges, points[k] - packing.labels.origin), packing.fraction[k],
              packing.image[k]))
      file.fail(fmt::format("particle {}: the position is not finite or too many cells away", k + 1));
  }
}

/// The particles in the order of their ids; also stores unusual ids in the packing's labels.
std::vector<std::size_t> order_by_id(VtpReader& file, Packing& packing) {
  std::vector<std::size_t> order(packing.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!file.has("PointData", "id")) return order;
  std::vector<std::int64_t> id;
  for (const double number : file.numbers("PointData", "id", file.points(), 1))
    id.push_back(whole(file, number, 9e15, "id"));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  bool usual = true;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && id[order[k]] == id[order[k - 1]])
      file.fail(fmt::format("the id {} occurs twice; each id must occur once", id[order[k]]));
    usual = usual && id[order[k]] == static_cast<std::int64_t>(k) + 1;
  }
  if (!usual) packing.labels.id = std::move(id);
  return order;
}

/// Puts all arrays of particles into this order.
void reorder(Packing& p, const std::vector<std::size_t>& order) {
  if (std::is_sorted(order.begin(), order.end())) return;
  const auto put = [&](auto& list) {
    if (list.empty()) return;
    auto sorted = list;
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = list[order[k]];
    list = std::move(sorted);
  };
  put(p.labels.id), put(p.labels.type), put(p.species), put(p.radius), put(p.mass), put(p.fraction);
  put(p.image), put(p.velocity), put(p.spin), put(p.force), put(p.torque);
}

}  // namespace

void write_vtp(const Packing& packing, const std::filesystem::path& path) {
  const std::size_t n = packing.size();
  const std::vector<std::int32_t> contacts = coordination(packing);
  const Vec3<double>& corner = packing.labels.origin;
  const auto each = [n](const char* name, auto element) { return data_array(name, n, element); };
  const auto one = [](const char* name, auto value) {
    return data_array(name, 1, [value](std::size_t) { return value; });
  };
  write_poly_data(
      {.points = each("Points", [&](std::size_t k) { return packing.position(k) + corner; }),
       .points_of_a_cell = 1,
       .field = {one("cell", matrix(packing.cell.edges)), one("rate", matrix(packing.cell.rate)),
                 one("TimeValue", packing.time), one("step", packing.step), one("origin", corner)},
       .of_points = {each("id", [&](std::size_t k) { return packing.id(k); }),
                     each("type", [&](std::size_t k) { return type_of(packing, k); }),
                     each("species",
                          [&](std::size_t k) { return static_cast<std::uint8_t>(packing.species[k]); }),
                     each("radius", [&](std::size_t k) { return packing.radius[k]; }),
                     each("mass", [&](std::size_t k) { return packing.mass[k]; }),
                     each("image", [&](std::size_t k) { return packing.image[k]; }),
                     each("velocity", [&](std::size_t k) { return packing.velocity[k]; }),
                     each("spin", [&](std::size_t k) { return packing.spin[k]; }),
                     each("force", [&](std::size_t k) { return packing.force[k]; }),
                     each("torque", [&](std::size_t k) { return packing.torque[k]; }),
                     each("coordination", [&](std::size_t k) { return contacts[k]; })}},
      path);
}

void write_contacts_vtp(const Packing& packing, const std::filesystem::path& path) {
  const std::vector<Contact>& contacts = packing.contacts;
  const auto end = [&](std::size_t k) {
    const Contact& c = contacts[k / 2];
    const Vec3<double> i = packing.position(c.i) + packing.labels.origin;
    return k % 2 == 0 ? i : i - c.branch;
  };
  const auto each = [&](const char* name, auto value) {
    return data_array(name, contacts.size(),
                      [&contacts, value](std::size_t k) { return value(contacts[k]); });
  };
  write_poly_data(
      {.points = data_array("Points", 2 * contacts.size(), end),
       .points_of_a_cell = 2,
       .of_cells = {each("i", [&](const Contact& c) { return packing.id(static_cast<std::size_t>(c.i)); }),
                    each("j", [&](const Contact& c) { return packing.id(static_cast<std::size_t>(c.j)); }),
                    each("force", [](const Contact& c) { return c.force; }),
                    each("normal_force", normal_force), each("tangential_force", tangential_force),
                    each("overlap", [](const Contact& c) { return c.overlap; }),
                    each("sliding", [](const Contact& c) { return std::uint8_t{c.sliding}; })}},
      path);
}

void write_cell_vtp(const Packing& packing, const std::filesystem::path& path) {
  const std::vector<Vec3<double>> ends = ends_of_edges(packing.cell);
  write_poly_data({.points = data_array("Points", ends.size(),
                                        [&](std::size_t k) { return ends[k] + packing.labels.origin; }),
                   .points_of_a_cell = 2},
                  path);
}

Packing read_vtp(const std::filesystem::path& path) {
  VtpReader file(path);
  if (!file.has("FieldData", "cell") || !file.has("PointData", "radius") || !file.has("Points", "Points"))
    file.fail("the points, the field array cell (9 numbers) and the point array radius are needed");
  Packing packing;
  read_sizes(file, packing);
  read_species(file, packing);
  read_field(file, packing);
  packing.velocity = vectors(file, "PointData", "velocity");
  packing.spin = vectors(file, "PointData", "spin");
  packing.force = vectors(file, "PointData", "force");
  packing.torque = vectors(file, "PointData", "torque");
  check_packing(packing, path);
  read_positions(file, packing);
  reorder(packing, order_by_id(file, packing));
  return packing;
}

}  // namespace furnas
