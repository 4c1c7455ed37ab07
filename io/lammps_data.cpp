#include "io/lammps_data.h"

#include <algorithm>
#include <map>
#include <optional>

#include "engine/base/numbers.h"
#include "io/lammps_header.h"
#include "io/lammps_tilt.h"
#include "io/particle_rows.h"
#include "io/species_type.h"
#include "io/text_reader.h"
#include "io/text_writer.h"

namespace furnas {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view step_in_title = "timestep = ";

/// A line of the section Velocities.
struct VelocityRow {
  std::int64_t id{};
  std::int64_t line{};
  Vec3<double> velocity, spin;
};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// The step in a title; 0 if it contains none.
std::int64_t step_of_title(std::string_view title) {
  const std::size_t at = title.find(step_in_title);
  if (at == title.npos) return 0;
  const std::string_view rest = title.substr(at + step_in_title.size());
  return number_in<std::int64_t>(rest.substr(0, rest.find_first_not_of("0123456789"))).value_or(0);
}

/// Reads the file section by section; a section begins with a capital letter.
class DataReader {
 public:
  explicit DataReader(const std::filesystem::path& path) : reader_(path) {}

  Packing read() {
    reader_.require_line("a title line");
    const std::int64_t step = step_of_title(reader_.line());
    header();
    while (!words_.empty()) section();
    if (rows_.empty()) reader_.fail("there is no section Atoms");
    join_velocities();
    Packing packing = assemble(reader_, header_.cell(), std::move(rows_), names());
    packing.step = step;
    return packing;
  }

 private:
  /// Goes to the next line that is not empty; at the end of the file `words_` is empty.
  void next() {
    words_.clear();
    while (words_.empty() && reader_.next_line()) words_ = reader_.words('#');
  }

  /// The words after '#' in the current line.
  std::vector<std::string> comment() const {
    const Words all = reader_.words();
    std::vector<std::string> found;
    bool behind = false;
    for (std::string_view word : all) {
      const std::size_t mark = behind ? 0 : word.find('#');
      if (mark == word.npos) continue;
      if (!behind) word.remove_prefix(mark + 1);
      behind = true;
      if (!word.empty()) found.emplace_back(word);
    }
    return found;
  }

  bool at_section() const {
    const char first = words_.empty() ? '\0' : words_[0][0];
    return first >= 'A' && first <= 'Z';
  }

  void header() {
    for (next(); !words_.empty() && !at_section(); next()) header_.take(reader_, words_, comment());
    header_.finish(reader_);
  }

  void section() {
    const std::string_view name = words_[0];
    if (name == "Atoms" && words_.size() == 1) return atoms();
    if (name == "Velocities" && words_.size() == 1) return velocities();
    if (name == "Masses" && words_.size() == 1) return masses();
    if (words_ == Words{"Atom", "Type", "Labels"}) return labels();
    if (is_one_of(name, {"Pair", "PairIJ"})) {  // contain nothing about spheres beyond Atoms
      for (next(); !words_.empty() && !at_section();) next();
      return;
    }
    reader_.fail(
        "unknown section; expected Atoms, Velocities, Masses, Atom Type Labels, Pair Coeffs or PairIJ "
        "Coeffs");
  }

  /// The masses of spheres follow from Atoms, so the numbers are ignored; but comments after them often name
  /// the types.
  void masses() {
    for (next(); !words_.empty() && !at_section(); next())
      if (const auto names = comment(); names.size() == 1 && words_.size() == 2)
        name_type(reader_.particle_type(words_[0]), names[0]);
  }

  void labels() {
    for (next(); !words_.empty() && !at_section(); next()) {
      if (words_.size() != 2) reader_.fail("expected 'type label' in the section Atom Type Labels");
      const std::string label(words_[1]);
      name_type(reader_.particle_type(words_[0]), label);
      if (!type_of_label_.emplace(label, reader_.particle_type(words_[0])).second)
        reader_.fail(fmt::format("the label {} occurs twice", label));
    }
  }

  void name_type(std::int32_t type, const std::string& name) {
    if (header_.types() && type > *header_.types()) reader_.fail("the type is not among those of the header");
    const auto place = static_cast<std::size_t>(type);
    constexpr std::size_t most_names = 100'000;
    if (place > most_names) reader_.fail(fmt::format("the type is beyond {}", most_names));
    if (names_.size() < place) names_.resize(place);
    names_[place - 1] = name;
  }

  /// The names of the types, if each type has one.
  std::vector<std::string> names() const {
    if (names_.empty()) return header_.names();
    const bool all =
        std::none_of(names_.begin(), names_.end(), [](const auto& name) { return name.empty(); });
    return all ? names_ : std::vector<std::string>();
  }

  /// Goes to the next line of a section and checks its number of columns.
  void section_line(std::size_t row, std::string_view section, std::size_t columns, std::size_t more,
                    const char* expected) {
    next();
    if (words_.empty() || at_section())
      reader_.fail(fmt::format("the section {} ends after {} lines; the header promises {}", section, row,
                               header_.count()));
    if (words_.size() != columns && words_.size() != more)
      reader_.fail(
          fmt::format("{} columns in the section {}; expected {}", words_.size(), section, expected));
  }

  /// After the last line of a section there must be another section or the end of the file.
  void end_section(std::string_view section) {
    next();
    if (!words_.empty() && !at_section())
      reader_.fail(
          fmt::format("the section {} has more lines than the {} of the header", section, header_.count()));
  }

  void atoms() {
    if (!rows_.empty()) reader_.fail("the section Atoms occurs here for the second time");
    const std::vector<std::string> style = comment();
    const bool bonded = !style.empty() && style[0] == "bpm/sphere";
    if (!style.empty() && !bonded && style[0] != "sphere")
      reader_.fail("the section Atoms has another style than 'Atoms # sphere' or 'Atoms # bpm/sphere'");
    const std::size_t columns = bonded ? 8 : 7;
    const char* const expected = bonded ? "8 or 11: id molecule type diameter density x y z [ix iy iz]"
                                        : "7 or 10: id type diameter density x y z [ix iy iz]";
    rows_.reserve(header_.count());
    for (std::size_t k = 0; k < header_.count(); ++k) {
      section_line(k, "Atoms", columns, columns + 3, expected);
      if (bonded) words_.erase(words_.begin() + 1);
      rows_.push_back(atom());
    }
    end_section("Atoms");
  }

  ParticleRow atom() const {
    ParticleRow row;
    row.line = reader_.line_number();
    row.id = reader_.integer(words_[0], "the id");
    row.type = type_in(words_[1]);
    row.radius = reader_.positive(words_[2], "the diameter") / 2;
    row.mass = sphere_mass(row.radius, reader_.positive(words_[3], "the density"));
    row.place = header_.cell().place_of(vector(4, "the position"));
    if (words_.size() == 10)
      row.image = {reader_.image(words_[7]), reader_.image(words_[8]), reader_.image(words_[9])};
    return row;
  }

  std::int32_t type_in(std::string_view word) const {
    if (const auto found = type_of_label_.find(word); found != type_of_label_.end()) return found->second;
    const std::int32_t type = reader_.particle_type(word);
    if (header_.types() && type > *header_.types()) reader_.fail("the type is not among those of the header");
    return type;
  }

  Vec3<double> vector(std::size_t column, std::string_view name) const {
    return {reader_.real(words_[column], name), reader_.real(words_[column + 1], name),
            reader_.real(words_[column + 2], name)};
  }

  void velocities() {
    if (!velocities_.empty()) reader_.fail("the section Velocities occurs here for the second time");
    velocities_.reserve(header_.count());
    for (std::size_t k = 0; k < header_.count(); ++k) {
      section_line(k, "Velocities", 7, 7, "7: id vx vy vz wx wy wz");
      velocities_.push_back({reader_.integer(words_[0], "the id"), reader_.line_number(),
                             vector(1, "the velocity"), vector(4, "the spin")});
    }
    end_section("Velocities");
  }

  void join_velocities() {
    if (velocities_.empty()) return;
    std::stable_sort(rows_.begin(), rows_.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    std::stable_sort(velocities_.begin(), velocities_.end(),
                     [](const auto& a, const auto& b) { return a.id < b.id; });
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (rows_[k].id != velocities_[k].id)
        reader_.fail_at(velocities_[k].line,
                        "the section Velocities must have each id of the section Atoms once and no other");
      rows_[k].velocity = velocities_[k].velocity;
      rows_[k].spin = velocities_[k].spin;
    }
  }

  TextReader reader_;
  Words words_;
  LammpsHeader header_;
  std::vector<std::string> names_;  ///< of the types, from sections
  std::map<std::string, std::int32_t, std::less<>>
      type_of_label_;  ///< labels that Atoms may use instead of numbers
  std::vector<ParticleRow> rows_;
  std::vector<VelocityRow> velocities_;
};

void write_data(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  const Triangle& h = packing.cell.edges;
  const Vec3<double>& corner = packing.labels.origin;
  const std::vector<std::string> names = names_of_types(packing);
  print(file, "LAMMPS data file written by furnas, {}{}\n\n", step_in_title, packing.step);
  print(file, "{} atoms\n{} atom types", packing.size(), names.size());
  if (packing.labels.type.empty() || !packing.labels.names.empty()) {
    print(file, "  #");
    for (const std::string& name : names) print(file, " {}", name);
  }
  print(file, "\n\n{} {} xlo xhi\n", corner.x, corner.x + h.xx);
  print(file, "{} {} ylo yhi\n{} {} zlo zhi\n", corner.y, corner.y + h.yy, corner.z, corner.z + h.zz);
  print(file, "{} {} {} xy xz yz\n\nAtoms # sphere\n\n", h.xy, h.xz, h.yz);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double radius = packing.radius[k];
    const auto& [ix, iy, iz] = packing.image[k];
    print(file, "{} {} {} {} {} {} {} {}\n", packing.id(k), type_of(packing, k), 2 * radius,
          packing.mass[k] / sphere_mass(radius), packing.position(k) + corner, ix, iy, iz);
  }
  print(file, "\nVelocities\n\n");
  for (std::size_t k = 0; k < packing.size(); ++k)
    print(file, "{} {} {}\n", packing.id(k), packing.velocity[k], packing.spin[k]);
  file.commit();
}

}  // namespace

Packing read_lammps_data(const std::filesystem::path& path) { return DataReader(path).read(); }

void write_lammps_data(const Packing& packing, const std::filesystem::path& path) {
  write_for_lammps(packing, [&](const Packing& p) { write_data(p, path); });
}

}  // namespace furnas
