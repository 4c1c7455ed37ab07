#include "io/lammps_data.h"

#include <algorithm>
#include <array>
#include <optional>

#include "io/particle_rows.h"
#include "io/species_type.h"
#include "io/text_reader.h"
#include "io/text_writer.h"

namespace furnas {
namespace {

using Words = std::vector<std::string_view>;

/// A line of the section Velocities.
struct VelocityRow {
  std::int64_t id{};
  std::int64_t line{};
  Vec3<double> velocity, spin;
};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// Reads the file section by section; a section begins with a capital letter.
class DataReader {
 public:
  explicit DataReader(const std::filesystem::path& path) : reader_(path) {}

  Packing read() {
    reader_.require_line("a title line");
    header();
    while (!words_.empty()) section();
    if (rows_.empty()) reader_.fail("there is no section Atoms");
    join_velocities();
    return assemble(reader_, edges_, std::move(rows_));
  }

 private:
  /// Goes to the next line that is not empty; at the end of the file `words_` is empty.
  void next() {
    words_.clear();
    while (words_.empty() && reader_.next_line()) words_ = reader_.words('#');
  }

  bool at_section() const {
    const char first = words_.empty() ? '\0' : words_[0][0];
    return first >= 'A' && first <= 'Z';
  }

  void header() {
    for (next(); !words_.empty() && !at_section(); next()) header_line();
    if (!count_) reader_.fail("the header has no line 'N atoms' after the title, which is the first line");
    for (std::size_t a = 0; a < 3; ++a)
      if (!bounds_[a]) reader_.fail(fmt::format("the header has no line 'lo hi {0}lo {0}hi'", "xyz"[a]));
    edges_.xx = (*bounds_[0])[1] - (*bounds_[0])[0];
    edges_.yy = (*bounds_[1])[1] - (*bounds_[1])[0];
    edges_.zz = (*bounds_[2])[1] - (*bounds_[2])[0];
    check_edges(reader_, edges_);
  }

  void header_line() {
    const std::size_t n = words_.size();
    if (n == 2 && words_[1] == "atoms") {
      count_ = reader_.particle_count(words_[0], least_row);
    } else if (n == 3 && words_[1] == "atom" && words_[2] == "types") {
      types_ = reader_.integer(words_[0], "the number of atom types");
    } else if (n == 4 && words_[2].size() == 3 && words_[2].ends_with("lo") && words_[2][0] >= 'x' &&
               words_[2][0] <= 'z') {
      bounds_[static_cast<std::size_t>(words_[2][0] - 'x')] = {reader_.real(words_[0], "the lower bound"),
                                                               reader_.real(words_[1], "the upper bound")};
    } else if (n == 6 && words_[3] == "xy" && words_[4] == "xz" && words_[5] == "yz") {
      edges_.xy = reader_.real(words_[0], "xy");
      edges_.xz = reader_.real(words_[1], "xz");
      edges_.yz = reader_.real(words_[2], "yz");
    } else if (words_[0] != "0") {  // "0 bonds" and the like promise nothing
      reader_.fail(
          "unknown line in the header; expected 'N atoms', 'N atom types', 'lo hi xlo xhi' (y, z) or "
          "'a b c xy xz yz'");
    }
  }

  void section() {
    const std::string_view name = words_[0];
    if (name == "Atoms" && words_.size() == 1) return atoms();
    if (name == "Velocities" && words_.size() == 1) return velocities();
    if (is_one_of(name, {"Masses", "Pair", "PairIJ"})) {  // say nothing about spheres that Atoms does not
      for (next(); !words_.empty() && !at_section();) next();
      return;
    }
    reader_.fail("unknown section; expected Atoms, Velocities, Masses, Pair Coeffs or PairIJ Coeffs");
  }

  /// Goes to the next line of a section and checks its number of columns.
  void section_line(std::size_t row, std::string_view section, std::size_t columns, std::size_t more = 0) {
    next();
    if (words_.empty() || at_section())
      reader_.fail(
          fmt::format("the section {} ends after {} lines; the header promises {}", section, row, *count_));
    if (words_.size() != columns && words_.size() != more)
      reader_.fail(fmt::format("{} columns in the section {}; expected {}", words_.size(), section,
                               section == "Atoms" ? "7 or 10: id type diameter density x y z [ix iy iz]"
                                                  : "7: id vx vy vz wx wy wz"));
  }

  /// After the last line of a section there must be another section or the end of the file.
  void end_section(std::string_view section) {
    next();
    if (!words_.empty() && !at_section())
      reader_.fail(fmt::format("the section {} has more lines than the {} of the header", section, *count_));
  }

  void atoms() {
    if (!rows_.empty()) reader_.fail("the section Atoms stands here for the second time");
    const std::string& line = reader_.line();
    if (const auto comment = line.find('#'); comment != std::string::npos) {
      const std::string style = line.substr(comment + 1);
      if (style.find_first_not_of(" \t") != std::string::npos && style.find("sphere") == std::string::npos)
        reader_.fail("the section Atoms has another style than 'Atoms # sphere'");
    }
    rows_.reserve(*count_);
    for (std::size_t k = 0; k < *count_; ++k) {
      section_line(k, "Atoms", 7, 10);
      rows_.push_back(atom());
    }
    end_section("Atoms");
  }

  ParticleRow atom() const {
    ParticleRow row;
    row.line = reader_.line_number();
    row.id = reader_.integer(words_[0], "the id");
    const std::int64_t type = reader_.integer(words_[1], "the type");
    if (type < 1 || (types_ && type > *types_)) reader_.fail("the type is not among those of the header");
    row.radius = reader_.positive(words_[2], "the diameter") / 2;
    row.mass = sphere_mass(row.radius, reader_.positive(words_[3], "the density"));
    row.place = in_edges(edges_, vector(4, "the position") -
                                     Vec3<double>{(*bounds_[0])[0], (*bounds_[1])[0], (*bounds_[2])[0]});
    if (words_.size() == 10) row.image = {image(7), image(8), image(9)};
    return row;
  }

  Vec3<double> vector(std::size_t column, std::string_view name) const {
    return {reader_.real(words_[column], name), reader_.real(words_[column + 1], name),
            reader_.real(words_[column + 2], name)};
  }

  std::int32_t image(std::size_t column) const {
    const std::int64_t value = reader_.integer(words_[column], "the image");
    if (std::abs(value) > 1'000'000'000) reader_.fail("the image is beyond 1e9 cells");
    return static_cast<std::int32_t>(value);
  }

  void velocities() {
    if (!velocities_.empty()) reader_.fail("the section Velocities stands here for the second time");
    velocities_.reserve(*count_);
    for (std::size_t k = 0; k < *count_; ++k) {
      section_line(k, "Velocities", 7);
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

  static constexpr std::size_t least_row = 14;  ///< "1 1 1 1 0 0 0\n"

  TextReader reader_;
  Words words_;
  std::optional<std::size_t> count_;
  std::optional<std::int64_t> types_;
  std::array<std::optional<std::array<double, 2>>, 3> bounds_;
  Triangle edges_;
  std::vector<ParticleRow> rows_;
  std::vector<VelocityRow> velocities_;
};

}  // namespace

Packing read_lammps_data(const std::filesystem::path& path) { return DataReader(path).read(); }

void write_lammps_data(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  const Triangle& h = packing.cell.edges;
  print(file, "LAMMPS data file written by furnas, timestep = {}\n\n", packing.step);
  print(file, "{} atoms\n{} atom types\n\n", packing.size(), type_count(packing));
  print(file, "0 {} xlo xhi\n0 {} ylo yhi\n0 {} zlo zhi\n", h.xx, h.yy, h.zz);
  print(file, "{} {} {} xy xz yz\n\nAtoms # sphere\n\n", h.xy, h.xz, h.yz);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double radius = packing.radius[k];
    const auto& [ix, iy, iz] = packing.image[k];
    print(file, "{} {} {} {} {} {} {} {}\n", k + 1, type_of(packing.species[k]), 2 * radius,
          packing.mass[k] / sphere_mass(radius), packing.position(k), ix, iy, iz);
  }
  print(file, "\nVelocities\n\n");
  for (std::size_t k = 0; k < packing.size(); ++k)
    print(file, "{} {} {}\n", k + 1, packing.velocity[k], packing.spin[k]);
  file.commit();
}

}  // namespace furnas
