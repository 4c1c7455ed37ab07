#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "engine/simulation.h"
#include "io/case_file.h"
#include "io/case_protocol.h"
#include "io/lammps_data.h"
#include "io/lammps_dump.h"

namespace furnas {
namespace {

using Vectors = std::vector<Vec3<double>>;

struct Reference {
  const char* start;
  const char* cell;      ///< "nve" or "nph"
  const char* friction;  ///< as in the file's name
};

std::ostream& operator<<(std::ostream& out, const Reference& r) {
  return out << r.start << '.' << r.cell << ".mu" << r.friction;
}

std::string data(const std::string& file) { return std::string(FURNAS_SOURCE_DIR "/tests/data/") + file; }

std::vector<Packing> frames_of(const Reference& r) {
  return read_lammps_dump(data(std::string(r.start) + "." + r.cell + ".mu" + r.friction + ".dump"));
}

/// The simulation that LAMMPS ran, told through a case file.
std::unique_ptr<Simulation> simulation_of(const Reference& r) {
  const std::string start = data(std::string(r.start) + ".data");
  const Packing packing = read_lammps_data(start);
  const bool fixed = std::string(r.cell) == "nve";
  const std::string text =
      "[start]\nfile = \"" + start +
      "\"\n[contact]\nlaw = \"hooke_history\"\nvelocity = \"peculiar\"\nfriction = " + r.friction +
      "\n[compaction]\ndrag = 0.0\npressure = 1e-3\ncell = \"" + (fixed ? "fixed" : "triclinic") +
      "\"\ntime_step_absolute = 0.032415\n" +
      "inertia_absolute = " + std::to_string(9 * (packing.size() + 1)) + "\n";
  Case c = parse_case(text, "reference");
  c.compute.precision = "double";
  const Packing from = start_of(c);
  return make_simulation(model_of(c, from), from, 2);
}

/// Largest difference over the largest value.
double error(const Vectors& ours, const Vectors& theirs, const std::set<std::size_t>& but = {}) {
  double difference = 0;
  double size = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    size = std::max(size, norm(theirs[k]));
    if (!but.count(k)) difference = std::max(difference, norm(ours[k] - theirs[k]));
  }
  return size > 0 ? difference / size : difference;
}

double position_error(const Packing& ours, const Packing& theirs) {
  double largest = 0;
  for (std::size_t k = 0; k < ours.size(); ++k)
    largest =
        std::max(largest, norm(theirs.cell.edges * nearest_difference(ours.fraction[k], theirs.fraction[k])));
  return largest;
}

std::string name_of(const testing::TestParamInfo<Reference>& tested) {
  std::string name = testing::PrintToString(tested.param);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

class LegacyLaw : public testing::TestWithParam<Reference> {};

// hooke_history follows gran/hooke/history, in a fixed cell and with fix nph/sphere: forces and torques at
// step 0 to 1e-12, positions to 1e-10 after 50 steps (measured: 1e-13).
TEST_P(LegacyLaw, FollowsTheTrajectoryOfLammps) {
  const std::vector<Packing> frames = frames_of(GetParam());
  const std::unique_ptr<Simulation> simulation = simulation_of(GetParam());
  const bool spins = std::string(GetParam().friction) != "0";

  Packing ours = simulation->packing();
  EXPECT_LT(error(ours.force, frames[0].force), 1e-12);
  EXPECT_LT(error(ours.torque, frames[0].torque), 1e-12);
  for (std::size_t n = 1; n < frames.size(); ++n) {
    const Packing& theirs = frames[n];
    simulation->advance(theirs.step - simulation->step());
    ours = simulation->packing();
    EXPECT_LT(position_error(ours, theirs), 1e-10) << "step " << theirs.step;
    EXPECT_LT(error(ours.velocity, theirs.velocity), 1e-10);
    EXPECT_LT(error(ours.force, theirs.force), 1e-10);
    if (spins) {
      EXPECT_LT(error(ours.spin, theirs.spin), 1e-10);
    }
    EXPECT_NEAR(ours.cell.edges.xx, theirs.cell.edges.xx, 1e-11);
    EXPECT_NEAR(ours.cell.edges.xy, theirs.cell.edges.xy, 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(References, LegacyLaw,
                         testing::Values(Reference{"a3", "nve", "0"}, Reference{"a3", "nve", "0.3"},
                                         Reference{"a3", "nph", "0"}, Reference{"a3", "nph", "0.3"},
                                         Reference{"mono", "nph", "0.3"}),
                         name_of);

// The start of size ratio 8 holds pairs placed exactly at contact, where rounding decides whether they touch.
// Every particle without such a pair has the forces of LAMMPS.
TEST(LegacyLaw, AgreesOnAllParticlesThatDoNotTouchByRounding) {
  const Reference reference{"a8", "nve", "0.3"};
  const Packing theirs = frames_of(reference)[0];
  const Packing ours = simulation_of(reference)->packing();
  std::set<std::size_t> marginal;
  constexpr double by_rounding = 2e-14;
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3<double> branch = ours.cell.edges * nearest_difference(ours.fraction[i], ours.fraction[j]);
      if (std::abs(norm(branch) - ours.radius[i] - ours.radius[j]) < by_rounding) {
        marginal.insert(i);
        marginal.insert(j);
      }
    }
  EXPECT_GT(marginal.size(), 0U);
  EXPECT_LT(marginal.size(), ours.size() / 8);
  EXPECT_LT(error(ours.force, theirs.force, marginal), 1e-12);
  EXPECT_LT(error(ours.torque, theirs.torque, marginal), 1e-12);
}

}  // namespace
}  // namespace furnas
