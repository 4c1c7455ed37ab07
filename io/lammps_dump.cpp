#include "io/lammps_dump.h"

#include <algorithm>
#include <array>
#include <optional>

#include "io/columns.h"
#include "io/frames.h"
#include "io/lammps_tilt.h"
#include "io/particle_rows.h"
#include "io/species_type.h"
#include "io/text_reader.h"
#include "io/text_writer.h"

namespace furnas {
namespace {

/// What a triclinic cell's bounding box adds below and above the cell's own bounds in x and y.
struct Overhang {
  double x_low, x_high, y_low, y_high;
  explicit Overhang(const Triangle& h)
      : x_low(std::min({0.0, h.xy, h.xz, h.xy + h.xz})),
        x_high(std::max({0.0, h.xy, h.xz, h.xy + h.xz})),
        y_low(std::min(0.0, h.yz)),
        y_high(std::max(0.0, h.yz)) {}
};

/// How the columns of a dump give positions.
enum class Positions { cartesian, scaled };

/// Reads a dump frame by frame.
class DumpReader {
 public:
  explicit DumpReader(const std::filesystem::path& path) : reader_(path) {}

  /// The next frame; nothing at the end of the file.
  std::optional<Packing> next() {
    step_.reset(), count_.reset(), cell_.reset();
    time_ = 0;
    while (reader_.next_line()) {
      if (reader_.words().empty()) continue;
      const std::string item = reader_.line();
      if (item.starts_with("ITEM: ATOMS")) return atoms();
      header_item(item);
    }
    if (step_ || count_ || cell_) reader_.fail("the file ends within a frame, before 'ITEM: ATOMS'");
    return std::nullopt;
  }

  [[noreturn]] void fail(std::string_view what) const { reader_.fail(what); }

 private:
  void header_item(const std::string& item) {
    if (item.starts_with("ITEM: BOX BOUNDS")) return box(item);
    if (!item.starts_with("ITEM: "))
      reader_.fail("expected 'ITEM: TIMESTEP', 'ITEM: NUMBER OF ATOMS', 'ITEM: BOX BOUNDS' or 'ITEM: ATOMS'");
    reader_.require_line("the value of " + item);
    const auto words = reader_.words();
    if (words.size() != 1) reader_.fail("one value is expected below " + item);
    if (item.starts_with("ITEM: TIMESTEP")) {
      step_ = reader_.integer(words[0], "the step");
    } else if (item.starts_with("ITEM: NUMBER OF ATOMS")) {
      count_ = reader_.particle_count(words[0], least_row);
    } else if (item.starts_with("ITEM: TIME")) {
      time_ = reader_.real(words[0], "the time");
    }
  }

  void box(const std::string& item) {
    const auto words = reader_.words();  // ITEM: BOX BOUNDS [xy xz yz, or abc origin] [pp pp pp]
    std::vector<std::string_view> rest(words.begin() + 3, words.end());
    const auto begins_with = [&](std::initializer_list<std::string_view> head) {
      if (rest.size() < head.size() || !std::equal(head.begin(), head.end(), rest.begin())) return false;
      rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(head.size()));
      return true;
    };
    const bool general = begins_with({"abc", "origin"});
    const bool tilted = !general && begins_with({"xy", "xz", "yz"});
    if (rest.size() == 3 && std::count(rest.begin(), rest.end(), "pp") != 3 &&
        std::all_of(rest.begin(), rest.end(), [](std::string_view flag) { return flag.size() == 2; }))
      reader_.fail("the cell must be periodic in all directions, 'pp pp pp'");
    if (!rest.empty() && (rest.size() != 3 || std::count(rest.begin(), rest.end(), "pp") != 3))
      reader_.fail(
          "expected 'ITEM: BOX BOUNDS', then nothing, 'xy xz yz' or 'abc origin', then nothing or 'pp pp "
          "pp'");
    if (general)
      general_cell(item);
    else
      upright_cell(item, tilted);
    cell_->check(reader_);
  }

  /// The `count` numbers of the next line; `expected` describes them in an error.
  std::vector<double> bounds(const std::string& item, std::size_t count, const char* expected) {
    reader_.require_line("a line of " + item);
    std::vector<double> numbers;
    for (const std::string_view word : reader_.words()) numbers.push_back(reader_.real(word, "the bound"));
    if (numbers.size() != count) reader_.fail(fmt::format("expected '{}'", expected));
    return numbers;
  }

  void general_cell(const std::string& item) {
    std::array<Vec3<double>, 3> edges;
    std::array<double, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = bounds(item, 4, "x, y and z of an edge, and a coordinate of the origin");
      edges[k] = {row[0], row[1], row[2]};
      corner[k] = row[3];
    }
    cell_.emplace(edges[0], edges[1], edges[2], Vec3<double>{corner[0], corner[1], corner[2]});
  }

  void upright_cell(const std::string& item, bool tilted) {
    std::array<std::array<double, 3>, 3> rows{};
    for (auto& row : rows) {
      const auto numbers = bounds(item, tilted ? 3 : 2, tilted ? "lo hi tilt" : "lo hi");
      std::copy(numbers.begin(), numbers.end(), row.begin());
    }
    Triangle h{.xx = 0, .yy = 0, .zz = 0, .yz = rows[2][2], .xz = rows[1][2], .xy = rows[0][2]};
    const Overhang over(h);
    const Vec3<double> corner{rows[0][0] - over.x_low, rows[1][0] - over.y_low, rows[2][0]};
    h.xx = rows[0][1] - over.x_high - corner.x;
    h.yy = rows[1][1] - over.y_high - corner.y;
    h.zz = rows[2][1] - corner.z;
    cell_.emplace(h, corner);
  }

  Packing atoms() {
    if (!step_ || !count_ || !cell_)
      reader_.fail(
          "'ITEM: ATOMS' must follow 'ITEM: TIMESTEP', 'ITEM: NUMBER OF ATOMS' and 'ITEM: BOX BOUNDS'");
    name_columns();
    NamedTypes names;
    std::vector<ParticleRow> rows;
    rows.reserve(*count_);
    for (std::size_t k = 0; k < *count_; ++k) {
      reader_.require_line(fmt::format("particle {} of {}", k + 1, *count_));
      columns_.row(reader_, reader_.words());
      rows.push_back(particle(static_cast<std::int64_t>(k) + 1));
      if (!name_column_.empty()) names.note(columns_.word(name_column_), rows.back());
    }
    std::vector<std::string> type_names = names.finish(rows);
    Packing packing = assemble(reader_, *cell_, std::move(rows), std::move(type_names));
    packing.step = *step_;
    packing.time = time_;
    return packing;
  }

  void name_columns() {
    const auto words = reader_.words();
    columns_.name(reader_, {words.begin() + 2, words.end()});
    if (!columns_.has("radius") && !columns_.has("diameter"))
      reader_.fail("there is no column radius or diameter");
    const auto use = [&](const char* suffix, Positions kind) {
      position_ = {std::string("x") + suffix, std::string("y") + suffix, std::string("z") + suffix};
      positions_ = kind;
      return columns_.has_all({position_.begin(), position_.end()});
    };
    if (!use("u", Positions::cartesian) && !use("su", Positions::scaled) && !use("", Positions::cartesian) &&
        !use("s", Positions::scaled))
      reader_.fail("there are no columns x y z, xs ys zs, xu yu zu or xsu ysu zsu");
    wrapped_ = !position_[0].ends_with('u');
    name_column_ = columns_.has("typelabel") ? "typelabel" : columns_.has("element") ? "element" : "";
  }

  ParticleRow particle(std::int64_t row_number) const {
    ParticleRow row;
    row.line = reader_.line_number();
    row.id = columns_.integer("id", row_number);
    row.radius = columns_.has("radius") ? columns_.real("radius") : columns_.real("diameter") / 2;
    if (row.radius <= 0) reader_.fail("the radius must be above zero");
    row.type = columns_.type("type");
    row.mass = columns_.real("mass", sphere_mass(row.radius, columns_.real("density", 1)));
    const Vec3<double> at = columns_.vector(position_[0], position_[1], position_[2]);
    row.place = positions_ == Positions::cartesian ? cell_->place_of(at) : cell_->place_of_scaled(at);
    if (wrapped_) row.image = {columns_.image("ix"), columns_.image("iy"), columns_.image("iz")};
    row.velocity = columns_.vector("vx", "vy", "vz");
    row.spin = columns_.vector("omegax", "omegay", "omegaz");
    row.force = columns_.vector("fx", "fy", "fz");
    row.torque = columns_.vector("tqx", "tqy", "tqz");
    return row;
  }

  static constexpr std::size_t least_row = 8;  ///< "1 0 0 0\n"

  TextReader reader_;
  Columns columns_;
  std::optional<std::int64_t> step_;
  std::optional<std::size_t> count_;
  std::optional<FileCell> cell_;
  double time_ = 0;
  std::array<std::string, 3> position_;
  Positions positions_ = Positions::cartesian;
  bool wrapped_ = false;
  std::string name_column_;  ///< of the names of types; empty without one
};

void write_dump(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  const Triangle& h = packing.cell.edges;
  const Overhang over(h);
  const Vec3<double>& corner = packing.labels.origin;
  const bool named = !packing.labels.names.empty();
  const std::vector<std::string> names = named ? names_of_types(packing) : std::vector<std::string>{};
  if (packing.time != 0) print(file, "ITEM: TIME\n{}\n", packing.time);
  print(file, "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", packing.step, packing.size());
  print(file, "ITEM: BOX BOUNDS xy xz yz pp pp pp\n");
  print(file, "{} {} {}\n", corner.x + over.x_low, corner.x + (h.xx + over.x_high), h.xy);
  print(file, "{} {} {}\n", corner.y + over.y_low, corner.y + (h.yy + over.y_high), h.xz);
  print(file, "{} {} {}\n", corner.z, corner.z + h.zz, h.yz);
  print(file,
        "ITEM: ATOMS id type{} mass radius xu yu zu vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz\n",
        named ? " element" : "");
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const std::int32_t type = type_of(packing, k);
    print(file, "{} {}{} {} {} {} {} {} {} {}\n", packing.id(k), type,
          named ? " " + names.at(static_cast<std::size_t>(type) - 1) : "", packing.mass[k], packing.radius[k],
          packing.unwrapped(k) + corner, packing.velocity[k], packing.spin[k], packing.force[k],
          packing.torque[k]);
  }
  file.commit();
}

}  // namespace

std::vector<Packing> read_lammps_dump(const std::filesystem::path& path) {
  DumpReader reader(path);
  std::vector<Packing> frames;
  while (auto frame = reader.next()) frames.push_back(std::move(*frame));
  if (frames.empty()) reader.fail("there is no frame; expected 'ITEM: TIMESTEP'");
  return frames;
}

Packing read_lammps_frame(const std::filesystem::path& path, std::optional<std::int64_t> frame) {
  DumpReader reader(path);
  return chosen_frame(reader, frame);
}

void write_lammps_dump(const Packing& packing, const std::filesystem::path& path) {
  write_for_lammps(packing, [&](const Packing& p) { write_dump(p, path); });
}

}  // namespace furnas
