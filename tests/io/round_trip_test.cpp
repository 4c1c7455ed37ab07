#include <fmt/format.h>
#include <rapidcheck.h>

#include "engine/state/shorter_edges.h"
#include "io/checkpoint.h"
#include "io/formats.h"
#include "io/particle_rows.h"
#include "io/species_type.h"
#include "tests/engine/support/property.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

/// Which spheres a packing has, and what files call them.
enum class Spheres { two_sizes, types_swapped, named, three_types, many_sizes, one_size };

/// A packing that has all that files can say.
Packing any_packing(std::uint64_t seed, Spheres spheres) {
  Packing p = random_packing(static_cast<unsigned>(seed), 3 + seed % 30);
  std::mt19937_64 random(seed);
  if (seed % 4 == 0) p.cell.edges.xy = 0.53 * p.cell.edges.xx;  // as a jammed cell may be, and LAMMPS refuses
  std::vector<std::int32_t> type;
  for (std::size_t k = 0; k < p.size(); ++k) type.push_back(type_of(p.species[k]));
  std::vector<std::string> names;
  if (spheres == Spheres::types_swapped)
    for (std::int32_t& t : type) t = 3 - t;
  if (spheres == Spheres::named) names = {"Zr", "Cu"};
  if (spheres == Spheres::three_types) {
    names = {"stone", "ice", "Fe"};
    for (std::size_t k = 0; k < p.size(); ++k) type[k] = static_cast<std::int32_t>(k % 3) + 1;
  }
  if (spheres == Spheres::many_sizes) {
    type.assign(p.size(), 1);
    for (double& r : p.radius) r *= 1 + 1e-3 * static_cast<double>(random() % 100);
  }
  if (spheres == Spheres::one_size) p.radius.assign(p.size(), 0.5);
  label_by_types(p, type, names);
  if (seed % 3 != 0) {
    std::int64_t id = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
      p.labels.id.push_back(id += 1 + static_cast<std::int64_t>(random() % 9));
  }
  if (seed % 2 != 0) p.labels.origin = {1.25, -7.5, 1e-3};
  return p;
}

Packing through(const Packing& p, const Format& format, const TemporaryFolder& folder) {
  const auto path = folder / ("a" + std::string(extension_of(format.name)));
  write_packing(p, format.name, path);
  return read_packing(path);
}

/// All that both formats have a place for is the same, exactly or to the digits that a double has.
void expect_kept(Packing p, Packing q, const Places& places) {
  shorten_edges(p, 0.5), shorten_edges(q, 0.5);  // a data file has the shortest edges of the lattice
  RC_ASSERT(p.size() == q.size());
  RC_ASSERT(p.labels.id == q.labels.id);
  RC_ASSERT(p.species == q.species);
  RC_ASSERT(p.radius == q.radius);
  RC_ASSERT(p.velocity == q.velocity);
  RC_ASSERT(p.spin == q.spin);
  RC_ASSERT(p.step == q.step);
  RC_ASSERT(strain_between(p.cell.edges, q.cell.edges) < 1e-14);
  RC_ASSERT(norm(p.labels.origin - q.labels.origin) < 1e-14);
  for (std::size_t k = 0; k < p.size(); ++k) {
    RC_ASSERT(type_of(p, k) == type_of(q, k));
    RC_ASSERT(std::abs(p.mass[k] / q.mass[k] - 1) < 1e-15);
    RC_ASSERT(norm(p.unwrapped(k) - q.unwrapped(k)) < 1e-11);
    if (places.names) RC_ASSERT(name_of_type(p, type_of(p, k)) == name_of_type(q, type_of(q, k)));
  }
  if (places.time) RC_ASSERT(p.time == q.time);
  if (places.forces) RC_ASSERT(p.force == q.force && p.torque == q.torque);
  if (places.rate) RC_ASSERT(p.cell.rate == q.cell.rate);
}

Places in_both(const Places& a, const Places& b) {
  return {.cell = a.cell && b.cell,
          .time = a.time && b.time,
          .forces = a.forces && b.forces,
          .rate = a.rate && b.rate,
          .names = a.names && b.names};
}

TEST(RoundTrip, ThroughEveryPairOfFormatsKeepsWhatBothCanHold) {
  const TemporaryFolder folder;
  std::vector<Format> both_ways;
  for (const Format& format : formats())
    if (format.write && (format.read || format.read_frame)) both_ways.push_back(format);
  ASSERT_EQ(both_ways.size(), 4U);
  EXPECT_TRUE(test::holds(40, [&] {
    const std::uint64_t seed = test::any_seed();
    for (const Spheres spheres : {Spheres::two_sizes, Spheres::types_swapped, Spheres::named,
                                  Spheres::three_types, Spheres::many_sizes, Spheres::one_size}) {
      const Packing p = any_packing(seed, spheres);
      for (const Format& first : both_ways) {
        const Packing once = through(p, first, folder);
        for (const Format& second : both_ways) {
          RC_TAG(fmt::format("{} {}", first.name, second.name));
          expect_kept(p, through(once, second, folder), in_both(first.has, second.has));
        }
      }
    }
  }));
}

TEST(RoundTrip, OfACheckpointKeepsTheLabels) {
  const TemporaryFolder folder;
  const Packing p = any_packing(7, Spheres::three_types);
  write_checkpoint({p, "a case", {{"key", "value"}}}, folder / "a.checkpoint");
  const Checkpoint back = read_checkpoint(folder / "a.checkpoint");
  EXPECT_EQ(back.packing.labels, p.labels);
  EXPECT_EQ(back.extras, (std::map<std::string, std::string>{{"key", "value"}}));
}

TEST(LostIn, TellsWhatAFormatHasNoPlaceFor) {
  Packing p = any_packing(5, Spheres::named);
  EXPECT_EQ(lost_in(p, "lammps-data"),
            "the time, forces and torques, contacts with their histories, the strain rate of the cell");
  EXPECT_EQ(lost_in(p, "lammps-dump"), "contacts with their histories, the strain rate of the cell");
  EXPECT_EQ(lost_in(p, "vtp"), "contacts with their histories, the names of types");
  EXPECT_EQ(lost_in(p, "csv"),
            "the cell, image flags and the step, the time, contacts with their histories, the strain rate of "
            "the cell");
  p.contacts.clear();
  p.cell.rate = {};
  EXPECT_EQ(lost_in(p, "extxyz"), "");
}

}  // namespace
}  // namespace furnas
