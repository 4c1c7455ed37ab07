#include "io/particle_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "engine/state/shorter_edges.h"
#include "engine/state/species.h"
#include "engine/state/validate.h"
#include "io/species_type.h"

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
      reader.fail_at(rows[k].line, fmt::format("the id {} occurs already in line {}; each id occurs once",
                                               rows[k].id, rows[k - 1].line));
}

std::vector<std::int64_t> ids_of(const std::vector<ParticleRow>& rows) {
  bool usual = true;
  std::vector<std::int64_t> ids;
  for (const ParticleRow& row : rows) {
    ids.push_back(row.id);
    usual = usual && row.id == static_cast<std::int64_t>(ids.size());
  }
  return usual ? std::vector<std::int64_t>() : ids;
}

std::vector<std::int32_t> types_of(const std::vector<ParticleRow>& rows) {
  std::vector<std::int32_t> types;
  types.reserve(rows.size());
  for (const ParticleRow& row : rows) types.push_back(row.type);
  return types;
}

/// The species according to the name of each type; empty where a name is neither "large" nor "small".
std::optional<std::vector<Species>> species_by_name(const std::vector<std::int32_t>& types,
                                                    const std::vector<std::string>& names) {
  std::vector<Species> species;
  for (const std::int32_t type : types) {
    if (type < 1 || static_cast<std::size_t>(type) > names.size()) return {};
    const std::string& name = names[static_cast<std::size_t>(type) - 1];
    if (name != name_of(Species::large) && name != name_of(Species::small)) return {};
    species.push_back(name == name_of(Species::large) ? Species::large : Species::small);
  }
  return species;
}

bool are_usual(const std::vector<std::string>& names) {
  return names.empty() || (names[0] == name_of(Species::large) &&
                           (names.size() == 1 || (names.size() == 2 && names[1] == name_of(Species::small))));
}

std::optional<std::int32_t> type_number(std::string_view name) {
  const auto number = number_in<std::int32_t>(name);
  return number && *number >= 1 && *number <= most_types ? number : std::nullopt;
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
  if (is_tilted(h, most_tilt))
    reader.fail(fmt::format("the cell has the tilts {} {} {}; allowed: up to {:g} edges", h.xy, h.xz, h.yz,
                            most_tilt));
}

bool wrap(const Vec3<double>& place, Fraction& fraction, Image& image) {
  return wrap_one(place.x, fraction.x, image[0]) && wrap_one(place.y, fraction.y, image[1]) &&
         wrap_one(place.z, fraction.z, image[2]);
}

void NamedTypes::note(std::string_view name, ParticleRow& row) {
  if (row.type > 0) {
    numbered_.try_emplace(row.type, name);
  } else if (const auto found = known_.find(name); found != known_.end()) {
    row.type = found->second;
  } else {
    row.type = static_cast<std::int32_t>(known_.size()) + 1;
    known_.emplace(std::string(name), row.type);
  }
}

std::vector<std::string> NamedTypes::names_of_numbers() const {
  constexpr std::size_t largest_gap = 100;  // type numbers with larger gaps are not a list
  std::vector<std::string> names;
  for (const auto& [type, name] : numbered_) {
    const auto place = static_cast<std::size_t>(type) - 1;
    if (place > names.size() + largest_gap) return {};
    while (names.size() < place) names.push_back(std::to_string(names.size() + 1));
    names.push_back(name);
  }
  return names;
}

std::vector<std::string> NamedTypes::finish(std::vector<ParticleRow>& rows) const {
  if (known_.empty()) return names_of_numbers();
  const bool numbers = std::all_of(known_.begin(), known_.end(),
                                   [](const auto& entry) { return type_number(entry.first).has_value(); });
  const bool usual = std::all_of(known_.begin(), known_.end(), [](const auto& entry) {
    return entry.first == name_of(Species::large) || entry.first == name_of(Species::small);
  });
  std::vector<std::string> names;
  if (usual) names = {std::string(name_of(Species::large)), std::string(name_of(Species::small))};
  std::vector<std::int32_t> final_type(known_.size() + 1);
  std::int32_t next = 0;
  for (const auto& [name, type] : known_) {  // in alphabetical order
    ++next;
    const auto place = static_cast<std::size_t>(type);
    if (numbers)
      final_type[place] = *type_number(name);
    else if (usual)
      final_type[place] = name == name_of(Species::large) ? 1 : 2;
    else
      final_type[place] = next, names.push_back(name);
  }
  for (ParticleRow& row : rows) row.type = final_type[static_cast<std::size_t>(row.type)];
  return names;
}

void label_by_types(Packing& p, std::vector<std::int32_t> types, std::vector<std::string> names) {
  if (std::find(types.begin(), types.end(), 0) != types.end()) types.clear();
  auto by_name = types.empty() ? std::nullopt : species_by_name(types, names);
  p.species = by_name ? std::move(*by_name) : species_by_type(p.radius, types);
  keep_types(p, std::move(types), std::move(names));
}

void keep_types(Packing& p, std::vector<std::int32_t> types, std::vector<std::string> names) {
  if (types.empty() || std::set<std::string>(names.begin(), names.end()).size() < names.size()) names.clear();
  bool usual = true;
  for (std::size_t k = 0; k < types.size() && usual; ++k) usual = types[k] == type_of(p.species[k]);
  p.labels.type = usual ? std::vector<std::int32_t>() : std::move(types);
  p.labels.names = usual && are_usual(names) ? std::vector<std::string>() : std::move(names);
}

Packing assemble(const TextReader& reader, const FileCell& cell, std::vector<ParticleRow> rows,
                 std::vector<std::string> names) {
  const auto by_id = [](const ParticleRow& a, const ParticleRow& b) { return a.id < b.id; };
  if (!std::is_sorted(rows.begin(), rows.end(), by_id)) std::stable_sort(rows.begin(), rows.end(), by_id);
  check_ids(reader, rows);
  Packing packing;
  packing.cell.edges = cell.edges();
  packing.labels.origin = cell.origin();
  packing.labels.turned = cell.is_turned();
  packing.labels.id = ids_of(rows);
  packing.resize(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ParticleRow& row = rows[k];
    packing.radius[k] = row.radius;
    packing.mass[k] = row.mass;
    packing.image[k] = cell.image_of(row.image);
    if (!wrap(row.place, packing.fraction[k], packing.image[k]))
      reader.fail_at(row.line, "the position is too many cells away");
    if (!above_zero(row.mass)) reader.fail_at(row.line, "the mass must be above zero and finite");
    packing.velocity[k] = cell.turned(row.velocity);
    packing.spin[k] = cell.turned(row.spin);
    packing.force[k] = cell.turned(row.force);
    packing.torque[k] = cell.turned(row.torque);
  }
  label_by_types(packing, types_of(rows), std::move(names));
  return packing;
}

void check_packing(const Packing& packing, const std::filesystem::path& file) {
  if (const std::string flaw = flaw_of(packing); !flaw.empty()) throw InputError(file.string() + ": " + flaw);
}

}  // namespace furnas
