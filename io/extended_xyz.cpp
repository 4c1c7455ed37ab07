#include "io/extended_xyz.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "io/columns.h"
#include "io/frames.h"
#include "io/particle_rows.h"
#include "io/species_type.h"
#include "io/text_reader.h"
#include "io/text_writer.h"
#include "io/xyz_attributes.h"

namespace furnas {
namespace {

template <std::size_t n>
std::array<double, n> reals(const TextReader& reader, const std::string& text, const char* name) {
  const auto words = words_of_list(text);
  if (words.size() != n) reader.fail(fmt::format("{} has {} numbers; expected {}", name, words.size(), n));
  std::array<double, n> values{};
  std::transform(words.begin(), words.end(), values.begin(),
                 [&](const std::string& word) { return reader.real(word, name); });
  return values;
}

FileCell cell_of(const TextReader& reader, const XyzAttributes& given) {
  const std::string* lattice = given.first_of({"Lattice"});
  if (!lattice) reader.fail("Lattice=\"ax ay az bx by bz cx cy cz\" is missing");
  const auto [ax, ay, az, bx, by, bz, cx, cy, cz] = reals<9>(reader, *lattice, "Lattice");
  Vec3<double> corner;
  if (const std::string* origin = given.first_of({"Origin"})) {
    const auto [x, y, z] = reals<3>(reader, *origin, "Origin");
    corner = {x, y, z};
  }
  const FileCell cell({ax, ay, az}, {bx, by, bz}, {cx, cy, cz}, corner);
  cell.check(reader);
  return cell;
}

void check_periodic(const TextReader& reader, const XyzAttributes& given) {
  const std::string* pbc = given.first_of({"pbc"});
  if (!pbc) return;
  const auto words = words_of_list(*pbc);
  const auto yes = [](std::string word) {
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    return word == "t" || word == "true" || word == ".true." || word == "1";
  };
  if (words.size() != 3 || !std::all_of(words.begin(), words.end(), yes))
    reader.fail("the cell must be periodic in all directions, pbc=\"T T T\"");
}

/// Names of the columns: pos:R:3 gives pos.0 pos.1 pos.2, radius:R:1 gives radius.0.
std::vector<std::string> column_names(const TextReader& reader, const XyzAttributes& given) {
  const std::string* properties = given.first_of({"Properties"});
  if (!properties) reader.fail("Properties=species:S:1:pos:R:3:radius:R:1... is missing");
  std::vector<std::string> parts(1);
  for (const char letter : *properties) {
    if (letter == ':')
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  if (parts.size() % 3 != 0) reader.fail("Properties must be a list of name:type:columns");
  std::vector<std::string> names;
  for (std::size_t k = 0; k < parts.size(); k += 3) {
    const std::int64_t columns = reader.integer(parts[k + 2], "the number of columns of " + parts[k]);
    if (columns < 1 || columns > 100) reader.fail("a property must have 1 ... 100 columns");
    for (std::int64_t c = 0; c < columns; ++c) names.push_back(fmt::format("{}.{}", parts[k], c));
  }
  return names;
}

/// The first of these properties that the file has, with ".0" after its name; empty without one.
std::string property(const Columns& columns, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (std::string column = fmt::format("{}.0", name); columns.has(column)) return column;
  return {};
}

/// Three numbers of the property whose first column is given; zeros if there is none.
Vec3<double> vector(const Columns& columns, std::string column) {
  if (column.empty()) return {};
  Vec3<double> v;
  for (double* value : {&v.x, &v.y, &v.z}) {
    *value = columns.real(column);
    ++column.back();
  }
  return v;
}

/// Which columns contain which quantity; programs use different names.
struct Meaning {
  std::string diameter, radius, mass, velocity, momentum, force, spin, torque, image, id, name, type;

  explicit Meaning(const Columns& c)
      : diameter(property(c, {"diameter", "diameters"})),
        radius(property(c, {"radius", "radii"})),
        mass(property(c, {"mass", "masses"})),
        velocity(property(c, {"velo", "velocities", "velocity", "vel"})),
        momentum(property(c, {"momenta"})),
        force(property(c, {"force", "forces"})),
        spin(property(c, {"angular_velocity", "omega"})),
        torque(property(c, {"torque", "torques"})),
        image(property(c, {"image"})),
        id(property(c, {"id"})),
        name(property(c, {"species_name", "species"})),
        type(property(c, {"species_type", "type"})) {}
};

/// Reads a file frame by frame.
class XyzReader {
 public:
  explicit XyzReader(const std::filesystem::path& path) : reader_(path) {}

  /// The next frame; nothing at the end of the file.
  std::optional<Packing> next() {
    do
      if (!reader_.next_line()) return std::nullopt;
    while (frames_ > 0 && reader_.words().empty());
    const auto words = reader_.words();
    if (words.size() != 1)
      reader_.fail(frames_ == 0 ? std::string("the first line must be the number of particles")
                                : fmt::format("more rows than the {} of the frame's first line", count_));
    count_ = reader_.particle_count(words[0], least_row);
    ++frames_;
    reader_.require_line("Lattice=\"...\" Properties=...");
    return rows_below(XyzAttributes(reader_));
  }

  [[noreturn]] void fail(std::string_view what) const { reader_.fail(what); }

 private:
  Packing rows_below(const XyzAttributes& given) {
    cell_ = cell_of(reader_, given);
    check_periodic(reader_, given);
    columns_.name(reader_, column_names(reader_, given));
    const Meaning means(columns_);
    if (!columns_.has_all({"pos.0", "pos.1", "pos.2"}) || (means.radius.empty() && means.diameter.empty()))
      reader_.fail("the Properties must have pos:R:3 and radius:R:1 (or diameter:R:1)");
    const std::string* step = given.first_of({"Step", "step", "Timestep", "timestep"});
    const std::string* time = given.first_of({"Time", "time"});
    const std::int64_t step_number = step ? reader_.integer(*step, "Step") : 0;
    const double time_number = time ? reader_.real(*time, "Time") : 0;
    NamedTypes names;
    std::vector<ParticleRow> rows;
    rows.reserve(count_);
    for (std::size_t k = 0; k < count_; ++k) {
      reader_.require_line(fmt::format("particle {} of {}", k + 1, count_));
      columns_.row(reader_, reader_.words());
      rows.push_back(particle(means, static_cast<std::int64_t>(k) + 1));
      if (!means.name.empty()) names.note(columns_.word(means.name), rows.back());
    }
    std::vector<std::string> type_names = names.finish(rows);
    Packing packing = assemble(reader_, cell_, std::move(rows), std::move(type_names));
    packing.step = step_number;
    packing.time = time_number;
    return packing;
  }

  ParticleRow particle(const Meaning& means, std::int64_t row_number) const {
    ParticleRow row;
    row.line = reader_.line_number();
    row.id = columns_.integer(means.id, row_number);
    row.radius = means.radius.empty() ? columns_.real(means.diameter) / 2 : columns_.real(means.radius);
    if (row.radius <= 0) reader_.fail("the radius must be above zero");
    row.mass = columns_.real(means.mass, sphere_mass(row.radius));
    row.place = cell_.place_of(vector(columns_, "pos.0"));
    if (!means.image.empty()) row.image = image(means.image);
    if (!means.type.empty()) row.type = columns_.type(means.type);
    row.velocity = vector(columns_, means.velocity);
    if (means.velocity.empty() && !means.momentum.empty())
      row.velocity = vector(columns_, means.momentum) * (1 / row.mass);
    row.spin = vector(columns_, means.spin);
    row.force = vector(columns_, means.force);
    row.torque = vector(columns_, means.torque);
    return row;
  }

  Image image(std::string column) const {
    Image found{};
    for (std::int32_t& cells : found) {
      cells = columns_.image(column);
      ++column.back();
    }
    return found;
  }

  static constexpr std::size_t least_row = 8;  ///< "0 0 0 1\n"

  TextReader reader_;
  std::int64_t frames_ = 0;
  std::size_t count_ = 0;
  FileCell cell_;
  Columns columns_;
};

}  // namespace

Packing read_extended_xyz(const std::filesystem::path& path, std::optional<std::int64_t> frame) {
  XyzReader reader(path);
  return chosen_frame(reader, frame);
}

void write_extended_xyz(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  const Triangle& h = packing.cell.edges;
  print(file, "{}\nLattice=\"{} 0 0 {} {} 0 {} {} {}\" Origin=\"{}\" pbc=\"T T T\" Step={} Time={} ",
        packing.size(), h.xx, h.xy, h.yy, h.xz, h.yz, h.zz, packing.labels.origin, packing.step,
        packing.time);
  // With names alone, a reader would number the types in alphabetical order.
  const bool numbered = !packing.labels.names.empty();
  print(file,
        "Properties=species:S:1:species_name:S:1:{}id:I:1:pos:R:3:image:I:3:radius:R:1:mass:R:1:velo:R:3:"
        "force:R:3:angular_velocity:R:3:torque:R:3\n",
        numbered ? "species_type:I:1:" : "");
  std::map<std::int32_t, std::string> words;  // of each type: its element and its name
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const std::int32_t type = type_of(packing, k);
    std::string& of_type = words[type];
    if (of_type.empty())
      of_type = fmt::format("{} {}{}", element_of(packing, k), name_of_type(packing, type),
                            numbered ? fmt::format(" {}", type) : "");
    const auto& [ix, iy, iz] = packing.image[k];
    print(file, "{} {} {} {} {} {} {} {} {} {} {} {}\n", of_type, packing.id(k),
          packing.position(k) + packing.labels.origin, ix, iy, iz, packing.radius[k], packing.mass[k],
          packing.velocity[k], packing.force[k], packing.spin[k], packing.torque[k]);
  }
  file.commit();
}

}  // namespace furnas
