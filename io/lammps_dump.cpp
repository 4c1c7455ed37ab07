#include "io/lammps_dump.h"

#include <algorithm>
#include <array>
#include <optional>

#include "io/columns.h"
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
    step_.reset(), count_.reset(), edges_.reset();
    while (reader_.next_line()) {
      if (reader_.words().empty()) continue;
      const std::string item = reader_.line();
      if (item.starts_with("ITEM: ATOMS")) return atoms();
      header_item(item);
    }
    if (step_ || count_ || edges_) reader_.fail("the file ends within a frame, before 'ITEM: ATOMS'");
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
    const auto words = reader_.words();  // ITEM: BOX BOUNDS [xy xz yz] pp pp pp
    const bool tilted = words.size() == 9 && words[3] == "xy" && words[4] == "xz" && words[5] == "yz";
    if (!tilted && words.size() != 6)
      reader_.fail("expected 'ITEM: BOX BOUNDS pp pp pp' or 'ITEM: BOX BOUNDS xy xz yz pp pp pp'");
    if (std::count(words.end() - 3, words.end(), "pp") != 3)
      reader_.fail("the cell must be periodic in all directions, 'pp pp pp'");
    std::array<std::array<double, 3>, 3> bounds{};
    for (auto& row : bounds) {
      reader_.require_line("a line of " + item);
      const auto numbers = reader_.words();
      if (numbers.size() != (tilted ? 3 : 2))
        reader_.fail(tilted ? "expected 'lo hi tilt'" : "expected 'lo hi'");
      for (std::size_t a = 0; a < numbers.size(); ++a) row[a] = reader_.real(numbers[a], "the bound");
    }
    Triangle h{.xx = 0, .yy = 0, .zz = 0, .yz = bounds[2][2], .xz = bounds[1][2], .xy = bounds[0][2]};
    const Overhang over(h);
    origin_ = {bounds[0][0] - over.x_low, bounds[1][0] - over.y_low, bounds[2][0]};
    h.xx = bounds[0][1] - over.x_high - origin_.x;
    h.yy = bounds[1][1] - over.y_high - origin_.y;
    h.zz = bounds[2][1] - origin_.z;
    check_edges(reader_, h);
    edges_ = h;
  }

  Packing atoms() {
    if (!step_ || !count_ || !edges_)
      reader_.fail(
          "'ITEM: ATOMS' must follow 'ITEM: TIMESTEP', 'ITEM: NUMBER OF ATOMS' and 'ITEM: BOX BOUNDS'");
    name_columns();
    std::vector<ParticleRow> rows;
    rows.reserve(*count_);
    for (std::size_t k = 0; k < *count_; ++k) {
      reader_.require_line(fmt::format("particle {} of {}", k + 1, *count_));
      columns_.row(reader_, reader_.words());
      rows.push_back(particle(static_cast<std::int64_t>(k) + 1));
    }
    Packing packing = assemble(reader_, *edges_, std::move(rows));
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
  }

  ParticleRow particle(std::int64_t row_number) const {
    ParticleRow row;
    row.line = reader_.line_number();
    row.id = columns_.integer("id", row_number);
    row.radius = columns_.has("radius") ? columns_.real("radius") : columns_.real("diameter") / 2;
    if (row.radius <= 0) reader_.fail("the radius must be above zero");
    row.mass = columns_.has("mass") ? columns_.real("mass") : sphere_mass(row.radius);
    row.place = columns_.vector(position_[0], position_[1], position_[2]);
    if (positions_ == Positions::cartesian) row.place = in_edges(*edges_, row.place - origin_);
    if (wrapped_) row.place += columns_.vector("ix", "iy", "iz");
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
  std::optional<Triangle> edges_;
  double time_ = 0;
  Vec3<double> origin_;
  std::array<std::string, 3> position_;
  Positions positions_ = Positions::cartesian;
  bool wrapped_ = false;
};

}  // namespace

std::vector<Packing> read_lammps_dump(const std::filesystem::path& path) {
  DumpReader reader(path);
  std::vector<Packing> frames;
  while (auto frame = reader.next()) frames.push_back(std::move(*frame));
  if (frames.empty()) reader.fail("there is no frame; expected 'ITEM: TIMESTEP'");
  return frames;
}

Packing read_last_lammps_frame(const std::filesystem::path& path) {
  DumpReader reader(path);
  std::optional<Packing> last = reader.next();
  if (!last) reader.fail("there is no frame; expected 'ITEM: TIMESTEP'");
  while (auto frame = reader.next()) last = std::move(frame);
  return std::move(*last);
}

void write_lammps_dump(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  const Triangle& h = packing.cell.edges;
  const Overhang over(h);
  print(file, "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", packing.step, packing.size());
  print(file, "ITEM: BOX BOUNDS xy xz yz pp pp pp\n");
  print(file, "{} {} {}\n", over.x_low, h.xx + over.x_high, h.xy);
  print(file, "{} {} {}\n", over.y_low, h.yy + over.y_high, h.xz);
  print(file, "0 {} {}\n", h.zz, h.yz);
  print(file, "ITEM: ATOMS id type radius xu yu zu vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz\n");
  for (std::size_t k = 0; k < packing.size(); ++k)
    print(file, "{} {} {} {} {} {} {} {}\n", k + 1, type_of(packing.species[k]), packing.radius[k],
          packing.unwrapped(k), packing.velocity[k], packing.spin[k], packing.force[k], packing.torque[k]);
  file.commit();
}

}  // namespace furnas
