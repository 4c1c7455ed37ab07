#include "io/result.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/io/packings.h"

namespace furnas {
namespace {

using Json = nlohmann::json;

Result example(Verdict verdict) {
  Result r;
  r.verdict = verdict;
  r.reason = "because";
  Measures& m = r.measures;
  m.step = 123456;
  m.time = 4000.5;
  m.phi = 0.5875;
  m.cell.edges = {2, 3, 4, 0.1, 0.2, 0.3};
  m.stress = {1e-4, 2e-4, 3e-4, 4e-6, 5e-6, 6e-6};
  m.pressure = 2e-4;
  m.coordination = 4.25;
  m.sliding_share = 0.125;
  m.backbone_threshold = 3;
  m.force_imbalance = 3e-5;
  for (std::size_t n = 0; n < 3; ++n)
    m.rattlers[n] = {static_cast<int>(n) + 2,
                     10 + static_cast<int>(n),
                     40 + static_cast<int>(n),
                     900 - static_cast<int>(n),
                     2000,
                     4.5 + static_cast<double>(n)};
  r.rest.strain_drift = 7e-7;
  r.rest.stress_error = 2e-4;
  r.reached = {{2e-4, 0.57, 1000, 4.6, 1, 20, 1e-3}, {1e-4, 0.58, 2000, 4.7, 0, 10}};
  r.evaluations = 4321;
  r.state_hash = 0x0123456789abcdef;
  r.large = 200;
  r.small = 800;
  r.sizes = {2, 1, 1.6};
  r.mean_diameter = 1.12;
  r.time_step = 0.032415;
  r.pressure = 1e-4;
  r.wall_seconds = 2;
  r.cpu_seconds = 3.5;
  r.steps_here = 1'000'000;
  r.threads = 3;
  return r;
}

Json written(const Result& r, const Case& c = {}) {
  const TemporaryFolder folder;
  write_result(r, c, folder / "result.json");
  return Json::parse(content(folder / "result.json"));
}

TEST(Result, OnlyAJammedPackingHasAPhiJ) {
  EXPECT_EQ(written(example(Verdict::jammed))["phi_J"], 0.5875);
  EXPECT_EQ(example(Verdict::jammed).phi_J(), 0.5875);
  for (Verdict verdict : {Verdict::budget, Verdict::diverged, Verdict::interrupted}) {
    const Json json = written(example(verdict));
    EXPECT_TRUE(json["phi_J"].is_null());
    EXPECT_TRUE(json["force_balance"].is_null());
    EXPECT_EQ(json["phi"], 0.5875);
    EXPECT_EQ(json["verdict"], to_string(verdict));
    EXPECT_FALSE(example(verdict).phi_J().has_value());
  }
}

TEST(Result, HasEveryKeyThatIsPromised) {
  const Json json = written(example(Verdict::jammed));
  EXPECT_EQ(json["reason"], "because");
  EXPECT_EQ(json["state_hash"], "0123456789abcdef");
  EXPECT_EQ(json["strain_drift_in_2000_t_c"], 7e-7);
  EXPECT_EQ(json["stress_error"], 2e-4);
  EXPECT_EQ(json["minimizer_evaluations"], 4321);
  EXPECT_EQ(json["force_imbalance"], 3e-5);
  EXPECT_EQ(json["stress"],
            (Json{{"xx", 1e-4}, {"yy", 2e-4}, {"zz", 3e-4}, {"xy", 4e-6}, {"xz", 5e-6}, {"yz", 6e-6}}));
  EXPECT_EQ(json["Z"], 4.25);
  EXPECT_EQ(json["Z_backbone"], 5.5);
  EXPECT_EQ(json["sliding_share"], 0.125);
  EXPECT_EQ(json["time_step"], 0.032415);
  EXPECT_EQ(json["law"], "hooke_synchronized");
  EXPECT_EQ(json["friction"], 0.3);
  EXPECT_EQ(json["precision"], "mixed");
  EXPECT_EQ(json["steps"], 123456);
  EXPECT_EQ(json["time"], 4000.5);
  EXPECT_EQ(json["wall_seconds"], 2);
  EXPECT_EQ(json["cpu_seconds"], 3.5);
  EXPECT_EQ(json["million_particle_steps_per_second"], 500);
  EXPECT_EQ(json["particles"], 1000);
  EXPECT_EQ(json["threads"], 3);
  EXPECT_EQ(json["applied_pressure"], 1e-4);
  EXPECT_EQ(json["cell"], (Json{{"lx", 2}, {"ly", 3}, {"lz", 4}, {"xy", 0.3}, {"xz", 0.2}, {"yz", 0.1}}));
  EXPECT_EQ(
      json["diameters"],
      (Json{{"sizes", 2}, {"smallest", 1.0}, {"mean", 1.12}, {"largest", 1.6}, {"listed_unit", nullptr}}));
  // The volume over the face that the second and the third edge span.
  EXPECT_NEAR(json["thickness_in_largest_diameters"], 24 / std::hypot(12, 1.2, 0.57) / 1.6, 1e-12);
}

TEST(Result, CountsRattlersOfEachSpeciesAtEachThreshold) {
  const Json json = written(example(Verdict::jammed))["rattlers"];
  ASSERT_EQ(json.size(), 3u);
  for (int n = 0; n < 3; ++n) {
    const Json& row = json[static_cast<std::size_t>(n)];
    EXPECT_EQ(row["least_contacts"], n + 2);
    EXPECT_EQ(row["large"], 10 + n);
    EXPECT_EQ(row["small"], 40 + n);
    EXPECT_EQ(row["large_share"], (10 + n) / 200.0);
    EXPECT_EQ(row["small_share"], (40 + n) / 800.0);
    EXPECT_EQ(row["backbone"], 900 - n);
    EXPECT_EQ(row["applies"], n == 1) << "the threshold of this run is 3";
  }
  Result mono = example(Verdict::jammed);
  mono.small = 0;
  EXPECT_TRUE(written(mono)["rattlers"][0]["small_share"].is_null());
}

TEST(Result, ListsThePressuresThatWereReached) {
  const Json json = written(example(Verdict::budget))["resting_states"];
  const auto state = [](double p, const Json& phi_J, double phi, const Json& bound, int step, double z,
                        int large, int small) {
    return Json{{"pressure", p},           {"phi_J", phi_J},         {"phi", phi},
                {"phi_bound", bound},      {"step", step},           {"Z_backbone", z},
                {"large_rattlers", large}, {"small_rattlers", small}};
  };
  EXPECT_EQ(json, (Json{state(2e-4, {}, 0.57, 1e-3, 1000, 4.6, 1, 20),
                        state(1e-4, 0.58, 0.58, {}, 2000, 4.7, 0, 10)}))
      << "it settled at the first";
}

TEST(Result, TellsALooseBalanceFromATightOne) {
  Result r = example(Verdict::jammed);
  EXPECT_EQ(written(r)["force_balance"], "tight");
  r.rest.loosely = true;
  EXPECT_EQ(written(r)["force_balance"], "loose");
}

/// What was not found out is null, not zero: nobody must take it for perfect rest.
TEST(Result, SaysNothingOfWhatIsUnknown) {
  Result r = example(Verdict::budget);
  r.rest = {};
  r.measures.rattlers[1].backbone = 0;
  const Json json = written(r);
  for (const char* key : {"strain_drift_in_2000_t_c", "stress_error", "force_imbalance",
                          "backbone_kinetic_energy_per_particle"})
    EXPECT_TRUE(json[key].is_null()) << key;
}

TEST(Result, AFixedCellHasNoAppliedPressure) {
  Case c;
  c.compaction.cell = "fixed";
  EXPECT_TRUE(written(example(Verdict::budget), c)["applied_pressure"].is_null());
}

TEST(Result, NamesTheLawWithoutFriction) {
  Case c;
  c.contact.law = "hooke_history";
  c.contact.friction = 0;
  EXPECT_EQ(written(example(Verdict::budget), c)["law"], "hooke_history without friction");
}

/// A diverged state is written, too, as valid JSON.
TEST(Result, IsValidWhateverTheNumbersAre) {
  Result r = example(Verdict::diverged);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Measures& m = r.measures;
  m.phi = m.pressure = m.kinetic_energy = m.backbone_kinetic_energy = m.force_imbalance = m.mean_force = nan;
  m.largest_overlap = m.coordination = m.sliding_share = nan;
  m.stress.fill(std::numeric_limits<double>::infinity());
  m.cell.edges = {nan, nan, nan, nan, nan, nan};
  const Json json = written(r);
  EXPECT_TRUE(json["phi"].is_null());
  EXPECT_TRUE(json["stress"]["xy"].is_null());
  EXPECT_TRUE(json["cell"]["lx"].is_null());
}

}  // namespace
}  // namespace furnas
