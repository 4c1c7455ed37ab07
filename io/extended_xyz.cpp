#include "io/extended_xyz.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include "io/columns.h"
#include "io/particle_rows.h"
#include "io/species_type.h"
#include "io/text_reader.h"
#include "io/text_writer.h"

namespace furnas {
namespace {

using Attributes = std::map<std::string, std::string>;

/// The pairs key=value of the second line; a value in quotes may have blanks.
Attributes attributes(const TextReader& reader) {
  const std::string& line = reader.line();
  Attributes found;
  std::size_t k = 0;
  while ((k = line.find_first_not_of(" \t", k)) != std::string::npos) {
    const std::size_t equals = line.find_first_of("= \t", k);
    if (equals == std::string::npos || line[equals] != '=') {  // a word without a value
      k = std::min(equals, line.size());
      continue;
    }
    const std::string key = line.substr(k, equals - k);
    const bool in_quotes = equals + 1 < line.size() && line[equals + 1] == '"';
    const std::size_t begin = equals + (in_quotes ? 2 : 1);
    std::size_t end = in_quotes ? line.find('"', begin) : line.find_first_of(" \t", begin);
    if (in_quotes && end == std::string::npos) reader.fail("the value of " + key + " has no closing quote");
    end = std::min(end, line.size());
    if (!found.emplace(key, line.substr(begin, end - begin)).second)
      reader.fail(key + " stands twice in the line");
    k = end + (in_quotes ? 1 : 0);
  }
  return found;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

template <std::size_t n>
std::array<double, n> reals(const TextReader& reader, const std::string& text, const char* name) {
  const auto words = split(text, ' ');
  if (words.size() != n) reader.fail(fmt::format("{} has {} numbers; expected {}", name, words.size(), n));
  std::array<double, n> values{};
  std::transform(words.begin(), words.end(), values.begin(),
                 [&](const std::string& word) { return reader.real(word, name); });
  return values;
}

Triangle lattice(const TextReader& reader, const Attributes& given) {
  const auto found = given.find("Lattice");
  if (found == given.end()) reader.fail("Lattice=\"ax ay az bx by bz cx cy cz\" is missing");
  const auto [ax, ay, az, bx, by, bz, cx, cy, cz] = reals<9>(reader, found->second, "Lattice");
  if (ay != 0 || az != 0 || bz != 0)
    reader.fail("the first edge of the Lattice must lie along x and the second in the plane of x and y");
  const Triangle edges{.xx = ax, .yy = by, .zz = cz, .yz = cy, .xz = cx, .xy = bx};
  check_edges(reader, edges);
  return edges;
}

/// Names of the columns: pos:R:3 gives pos.0 pos.1 pos.2, radius:R:1 gives radius.0.
std::vector<std::string> column_names(const TextReader& reader, const Attributes& given) {
  const auto found = given.find("Properties");
  if (found == given.end()) reader.fail("Properties=species:S:1:pos:R:3:radius:R:1... is missing");
  const auto parts = split(found->second, ':');
  if (parts.size() % 3 != 0) reader.fail("Properties must be a list of name:type:columns");
  std::vector<std::string> names;
  for (std::size_t k = 0; k < parts.size(); k += 3) {
    const std::int64_t columns = reader.integer(parts[k + 2], "the number of columns of " + parts[k]);
    if (columns < 1 || columns > 100) reader.fail("a property must have 1 ... 100 columns");
    for (std::int64_t c = 0; c < columns; ++c) names.push_back(fmt::format("{}.{}", parts[k], c));
  }
  return names;
}

Vec3<double> vector(const Columns& columns, const std::string& name) {
  return columns.vector(name + ".0", name + ".1", name + ".2");
}

/// What the second line says.
struct Frame {
  Triangle edges;
  Vec3<double> origin;
  Columns columns;
};

Frame frame(const TextReader& reader, const Attributes& given) {
  Frame f;
  f.edges = lattice(reader, given);
  if (given.contains("Origin")) {
    const auto [x, y, z] = reals<3>(reader, given.at("Origin"), "Origin");
    f.origin = {x, y, z};
  }
  if (given.contains("pbc") && split(given.at("pbc"), ' ') != std::vector<std::string>{"T", "T", "T"})
    reader.fail("the cell must be periodic in all directions, pbc=\"T T T\"");
  f.columns.name(reader, column_names(reader, given));
  if (!f.columns.has_all({"pos.0", "pos.1", "pos.2", "radius.0"}))
    reader.fail("the Properties must have pos:R:3 and radius:R:1");
  return f;
}

ParticleRow particle(const TextReader& reader, const Frame& f, std::int64_t row_number) {
  const Columns& columns = f.columns;
  ParticleRow row;
  row.line = reader.line_number();
  row.id = columns.integer("id.0", row_number);
  row.radius = columns.real("radius.0");
  if (row.radius <= 0) reader.fail("the radius must be above zero");
  row.mass = columns.has("mass.0") ? columns.real("mass.0") : sphere_mass(row.radius);
  row.place = in_edges(f.edges, vector(columns, "pos") - f.origin);
  row.velocity = vector(columns, "velo");
  row.spin = vector(columns, "angular_velocity");
  row.force = vector(columns, "force");
  row.torque = vector(columns, "torque");
  return row;
}

}  // namespace

Packing read_extended_xyz(const std::filesystem::path& path) {
  constexpr std::size_t least_row = 8;  // "0 0 0 1\n"
  TextReader reader(path);
  reader.require_line("the number of particles");
  const auto words = reader.words();
  if (words.size() != 1) reader.fail("the first line must be the number of particles");
  const std::size_t count = reader.particle_count(words[0], least_row);
  reader.require_line("Lattice=\"...\" Properties=...");
  const Attributes given = attributes(reader);
  Frame f = frame(reader, given);
  const std::int64_t step = given.contains("Step") ? reader.integer(given.at("Step"), "Step") : 0;
  const double time = given.contains("Time") ? reader.real(given.at("Time"), "Time") : 0;
  std::vector<ParticleRow> rows;
  rows.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    reader.require_line(fmt::format("particle {} of {}", k + 1, count));
    f.columns.row(reader, reader.words());
    rows.push_back(particle(reader, f, static_cast<std::int64_t>(k) + 1));
  }
  Packing packing = assemble(reader, f.edges, std::move(rows));
  packing.step = step;
  packing.time = time;
  return packing;
}

void write_extended_xyz(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  const Triangle& h = packing.cell.edges;
  print(file, "{}\nLattice=\"{} 0 0 {} {} 0 {} {} {}\" Origin=\"0 0 0\" pbc=\"T T T\" Step={} Time={} ",
        packing.size(), h.xx, h.xy, h.yy, h.xz, h.yz, h.zz, packing.step, packing.time);
  print(file,
        "Properties=species:S:1:id:I:1:pos:R:3:radius:R:1:mass:R:1:velo:R:3:force:R:3:"
        "angular_velocity:R:3:torque:R:3\n");
  for (std::size_t k = 0; k < packing.size(); ++k)
    print(file, "{} {} {} {} {} {} {} {} {}\n", name_of(packing.species[k]), k + 1, packing.position(k),
          packing.radius[k], packing.mass[k], packing.velocity[k], packing.force[k], packing.spin[k],
          packing.torque[k]);
  file.commit();
}

}  // namespace furnas
