#include "io/particle_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/require.h"
#include "engine/state/species.h"
#include "engine/state/validate.h"

namespace furnas {
namespace {

bool above_zero(double value) { return std::isfinite(value) && value > 0; }

bool spans_a_cell(const Triangle& h) {
  return finite(h) && h.xx > 0 && h.yy > 0 && h.zz > 0 && above_zero(h.determinant());
}

bool wrap_one(double place, std::uint64_t& fraction, std::int32_t& image) {
  if (!(std::abs(place) < 1e9)) return false;
  fraction = to_fixed(place);
  // Not floor(place): just below a face the fraction may round to 0, and then the face has been crossed.
  const double crossed = std::nearbyint(place - static_cast<double>(fraction) * (1 / two_to_64));
  const std::int64_t sum = std::int64_t{image} + static_cast<std::int64_t>(crossed);
  if (std::abs(sum) > std::numeric_limits<std::int32_t>::max()) return false;
  image = static_cast<std::int32_t>(sum);
  return true;
}

void check_ids(const TextReader& reader, const std::vector<ParticleRow>& rows) {
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (rows[k].id == rows[k - 1].id)
      reader.fail_at(rows[k].line, fmt::format("the id {} stands already in line {}; each id occurs once",
                                               rows[k].id, rows[k - 1].line));
}

}  // namespace

Vec3<double> in_edges(const Triangle& h, const Vec3<double>& v) {
  const double z = v.z / h.zz;
  const double y = (v.y - h.yz * z) / h.yy;
  return {(v.x - h.xy * y - h.xz * z) / h.xx, y, z};
}

void check_edges(const TextReader& reader, const Triangle& h) {
  if (!spans_a_cell(h))
    reader.fail(
        fmt::format("the cell has the lengths {} {} {}; they and the volume must be above zero and finite",
                    h.xx, h.yy, h.zz));
}

bool wrap(const Vec3<double>& place, Fraction& fraction, Image& image) {
  return wrap_one(place.x, fraction.x, image[0]) && wrap_one(place.y, fraction.y, image[1]) &&
         wrap_one(place.z, fraction.z, image[2]);
}

Packing assemble(const TextReader& reader, const Triangle& edges, std::vector<ParticleRow> rows) {
  const auto by_id = [](const ParticleRow& a, const ParticleRow& b) { return a.id < b.id; };
  if (!std::is_sorted(rows.begin(), rows.end(), by_id)) std::stable_sort(rows.begin(), rows.end(), by_id);
  check_ids(reader, rows);
  Packing packing;
  packing.cell.edges = edges;
  packing.resize(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ParticleRow& row = rows[k];
    packing.radius[k] = row.radius;
    packing.mass[k] = row.mass;
    packing.image[k] = row.image;
    if (!wrap(row.place, packing.fraction[k], packing.image[k]))
      reader.fail_at(row.line, "the position is too many cells away");
    if (!above_zero(row.mass)) reader.fail_at(row.line, "the mass must be above zero and finite");
    packing.velocity[k] = row.velocity;
    packing.spin[k] = row.spin;
    packing.force[k] = row.force;
    packing.torque[k] = row.torque;
  }
  packing.species = species_by_size(packing.radius);
  return packing;
}

void check_packing(const Packing& packing, const std::filesystem::path& file) {
  if (const std::string flaw = flaw_of(packing); !flaw.empty()) throw InputError(file.string() + ": " + flaw);
}

}  // namespace furnas
