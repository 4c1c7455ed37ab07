#include "io/case_protocol.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/require.h"
#include "engine/monitor/energy.h"
#include "io/atomic_file.h"
#include "io/checkpoint.h"
#include "io/formats.h"
#include "io/vtp_packing.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::AllOf;
using testing::HasSubstr;

template <class Act>
std::string refusal_of_start(Act&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// A C++ program that says nothing and a case file that says nothing run the same protocol.
TEST(CaseProtocol, HasTheDefaultsOfTheEngine) {
  const Protocol of_case = protocol_of({}), own;
  const Packing packing = dilute_start({.large = 10});
  const Model a = model_of(of_case, packing), b = model_of(own, packing);
  EXPECT_EQ(a.law.index(), b.law.index());
  const HookeConstants &x = constants_of(a.law), &y = constants_of(b.law);
  EXPECT_EQ(x.friction, y.friction);
  EXPECT_EQ(x.tangential_stiffness, y.tangential_stiffness);
  EXPECT_EQ(x.normal_damping, y.normal_damping);
  EXPECT_EQ(x.tangential_damping, y.tangential_damping);
  EXPECT_EQ(x.attraction, y.attraction);
  EXPECT_EQ(x.winding, y.winding);
  EXPECT_EQ(a.precision, b.precision);
  EXPECT_EQ(a.time_step, b.time_step);
  EXPECT_EQ(a.affine_velocity, b.affine_velocity);
  EXPECT_EQ(a.skin, b.skin);
  EXPECT_EQ(a.barostat.freedom, b.barostat.freedom);
  EXPECT_EQ(a.barostat.inertia, b.barostat.inertia);
  EXPECT_EQ(a.barostat.drag, b.barostat.drag);
  EXPECT_EQ(of_case.pressures, own.pressures);
  EXPECT_EQ(of_case.steps, own.steps);
  EXPECT_EQ(of_case.rest.kinetic_energy_alone, own.rest.kinetic_energy_alone);
  EXPECT_EQ(of_case.rest.stress_error, own.rest.stress_error);
  EXPECT_EQ(of_case.rest.force_imbalance, own.rest.force_imbalance);
  EXPECT_EQ(of_case.rest.kinetic_energy, own.rest.kinetic_energy);
  EXPECT_EQ(of_case.rest.strain_drift, own.rest.strain_drift);
  EXPECT_EQ(of_case.rest.window, own.rest.window);
  EXPECT_EQ(of_case.minimizer, own.minimizer);
  EXPECT_EQ(mixture_of({}).start_fraction, Mixture{}.start_fraction);
  EXPECT_EQ(mixture_of({}).large, Mixture{}.large);
}

TEST(CaseProtocol, TakesEachKeyOfTheCase) {
  Case c;
  c.contact = {.law = "hooke_history",
               .friction = 0.1,
               .tangential_stiffness = 0.2,
               .normal_damping = 0.3,
               .tangential_damping = 0.4,
               .attraction = false,
               .winding = false,
               .velocity = "total"};
  c.compaction = {.pressure = {1e-3, 1e-4},
                  .cell = "cubic",
                  .inertia = 2,
                  .inertia_absolute = 3,
                  .cell_damping = 7,
                  .drag = 4,
                  .time_step = 0.01,
                  .time_step_absolute = 0.05};
  c.stop = {.criterion = "paper",
            .stress_error = 1,
            .force_imbalance = 2,
            .kinetic_energy = 3,
            .strain_drift = 4,
            .window = 5,
            .stilling = 8,
            .stilling_energy = 9,
            .growth = 10,
            .final_quenches = 11,
            .minimizer = false,
            .steps = 6};
  c.compute = {.precision = "double", .threads = 7, .skin = 0.8};
  const Protocol p = protocol_of(c);
  EXPECT_EQ(p.law, "hooke_history");
  EXPECT_EQ(p.contact.friction, 0.1);
  EXPECT_EQ(p.contact.tangential_stiffness, 0.2);
  EXPECT_EQ(p.contact.normal_damping, 0.3);
  EXPECT_EQ(p.contact.tangential_damping, 0.4);
  EXPECT_FALSE(p.contact.attraction);
  EXPECT_FALSE(p.contact.winding);
  EXPECT_TRUE(p.affine_velocity);
  EXPECT_EQ(p.pressures, (std::vector{1e-3, 1e-4}));
  EXPECT_EQ(p.cell, CellFreedom::cubic);
  EXPECT_EQ(p.inertia, 2);
  EXPECT_EQ(p.inertia_absolute, 3);
  EXPECT_EQ(p.cell_damping, 7);
  EXPECT_EQ(p.drag, 4);
  EXPECT_EQ(p.time_step, 0.01);
  EXPECT_EQ(p.time_step_absolute, 0.05);
  EXPECT_TRUE(p.rest.kinetic_energy_alone);
  EXPECT_EQ(p.rest.stress_error, 1);
  EXPECT_EQ(p.rest.force_imbalance, 2);
  EXPECT_EQ(p.rest.kinetic_energy, 3);
  EXPECT_EQ(p.rest.strain_drift, 4);
  EXPECT_EQ(p.rest.window, 5);
  EXPECT_EQ(p.rest.stilling, 8);
  EXPECT_EQ(p.rest.stilling_energy, 9);
  EXPECT_EQ(p.rest.growth, 10);
  EXPECT_EQ(p.rest.final_quenches, 11);
  EXPECT_FALSE(p.minimizer);
  EXPECT_EQ(p.steps, 6);
  EXPECT_EQ(p.precision, Precision::full);
  EXPECT_EQ(p.skin, 0.8);
}

TEST(CaseProtocol, AStartFromAFileBeginsItsOwnClock) {
  Case c;
  c.start.file = test_data("a3.nph.mu0.3.dump");
  const Packing packing = start_of(c);
  EXPECT_EQ(packing.step, 0);
  EXPECT_EQ(packing.time, 0);
  EXPECT_GT(packing.size(), 0u);
}

TEST(CaseProtocol, AStartFromAFileDoesNotDrift) {
  const TemporaryFolder folder;
  Packing still = dilute_start({.large = 20});
  for (std::size_t k = 0; k < still.size(); ++k) still.velocity[k] = {k % 2 ? 0.1 : -0.1, 0, 0};
  Packing drifting = still;
  for (Vec3<double>& velocity : drifting.velocity) velocity += {0.5, -1, 2};
  Case c;
  for (const auto& [name, packing] : {std::pair{"still.vtp", &still}, {"drifting.vtp", &drifting}}) {
    write_vtp(*packing, folder / name);
    c.start.file = (folder / name).string();
    const Packing start = start_of(c);
    for (std::size_t k = 0; k < start.size(); ++k)
      EXPECT_LT(norm(start.velocity[k] - still.velocity[k]), 1e-14) << name;
  }
}

// The same lattice as a cube: by the tilted edges its faces are a hundredth of a diameter apart.
TEST(CaseProtocol, AStartFromAFileMayBeTiltedByManyEdges) {
  const TemporaryFolder folder;
  const Packing cube = dilute_start({.large = 20});
  Packing tilted = cube;
  tilted.cell.edges.xy = 300 * cube.cell.edges.xx;
  for (std::size_t k = 0; k < cube.size(); ++k) tilted.fraction[k].x -= 300 * cube.fraction[k].y;
  write_vtp(tilted, folder / "tilted.vtp");
  Case c;
  c.start.file = (folder / "tilted.vtp").string();
  const Packing start = start_of(c);
  EXPECT_EQ(start.cell.edges.xy, 0);
  for (std::size_t k = 0; k < cube.size(); ++k)
    EXPECT_LT(norm(nearest_difference(start.fraction[k], cube.fraction[k])), 1e-12);
}

TEST(CaseProtocol, AStartFromACheckpointCountsItsEnergyAnew) {
  const TemporaryFolder folder;
  Packing packing = random_packing(3);
  for (Vec3<double>& velocity : packing.velocity) velocity = {1, 0, 0};
  write_checkpoint({packing, "", {}}, folder / "a.checkpoint");
  Case c;
  c.start.file = (folder / "a.checkpoint").string();
  const Packing start = start_of(c);
  EXPECT_EQ(start.ledger.initial, energy(start, law_of(protocol_of(c))).total());
  EXPECT_EQ(start.ledger.cell_work, 0);
  EXPECT_EQ(start.ledger.losses.total(), 0);
}

TEST(CaseProtocol, AListOfDiametersIsAStart) {
  const TemporaryFolder folder;
  std::string list = "# micrometres\n";
  for (int k = 0; k < 50; ++k) list += fmt::format("{}\n", 30 + (k * 17) % 50);
  write_file(folder / "sizes.txt", list);
  Case c;
  c.mixture.diameters = folder / "sizes.txt";
  const Packing packing = start_of(c);
  ASSERT_EQ(packing.size(), 50u);
  for (std::size_t k = 0; k < 50; ++k)
    EXPECT_DOUBLE_EQ(2 * packing.radius[k], static_cast<double>(30 + (k * 17) % 50) / 30)
        << "in the order of lines";
  EXPECT_NEAR(packing.fraction_filled(), 0.05, 1e-12);
  write_file(folder / "sizes.txt", "1\n1\n1\n");
  EXPECT_THAT(refusal_of_start([&] { start_of(c); }),
              HasSubstr("3 spheres make a cell only 1.3 smallest diameters"));
}

TEST(CaseProtocol, TheSmallestSpheresThatExistAreTheUnit) {
  Case c;
  c.mixture = {.size_ratio = 10, .large = 50};
  EXPECT_EQ(start_of(c).radius, std::vector<double>(50, 0.5))
      << "no small ones, so that the large ones are it";
  c.mixture.small_fraction = 0.01;
  EXPECT_EQ(start_of(c).radius.front(), 5);
}

}  // namespace
}  // namespace furnas
