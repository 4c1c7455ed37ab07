#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cases/program/run/recording.h"
#include "engine/start/mixture.h"
#include "tests/cases/runs.h"
#include "tests/cases/same_run.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

constexpr int window = 300;  // steps

/// A gas in a cell with an edge too many along x, which is the same lattice but must be flipped.
Packing tilted_gas() {
  Packing p =
      dilute_start({.size_ratio = 2, .small_fraction = 0.5, .large = 6, .start_fraction = 0.3, .seed = 3});
  p.cell.edges.xy += p.cell.edges.xx;
  for (Fraction& s : p.fraction) s.x -= s.y;
  return p;
}

/// So hasty that within the window spheres touch for the first time, stick and slip, the cell is flipped,
/// it is quenched and looks fill the window of the verdict; rows and frames are written all along.
constexpr const char* hasty_case = R"([start]
file = "gas.checkpoint"
[contact]
friction = 0.1
[compaction]
pressure = [2e-2, 3e-2]
inertia = 0.02
drag = 1.0
time_step = 0.02
[stop]
stress_error = 1.0
force_imbalance = 1.0
kinetic_energy = 1.0
strain_drift = 1.0
window = 1.0
steps = 300
[compute]
threads = 1
[output]
history_every = 7
snapshot_every = 60
snapshot_phi = 0.01
picture = "none"
)";

class HastyRuns : public Runs {
 public:
  HastyRuns() : Runs(hasty_case) { write_checkpoint({tilted_gas(), "", {}}, path("gas.checkpoint")); }
};

/// The numbers of a column of history.csv.
std::vector<double> column(const Runs& runs, const std::string& run, const std::string& name) {
  std::istringstream in(content(runs.path(run + "/history.csv")));
  std::string line, word;
  std::getline(in, line);
  std::istringstream header(line);
  int index = 0;
  while (std::getline(header, word, ',') && word != name) ++index;
  std::vector<double> values;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    for (int k = 0; k <= index; ++k) std::getline(row, word, ',');
    values.push_back(std::stod(word));
  }
  return values;
}

/// Guards the tests below: bits that agree say nothing about a window in which nothing happens.
TEST(ReliableSplitRun, TheWindowHasAllThatCanHappen) {
  const HastyRuns runs;
  ASSERT_EQ(runs.run("whole").code, ExitCode::budget_spent);
  ASSERT_EQ(runs.run("start", {"stop.steps=0"}).code, ExitCode::budget_spent);
  const auto result = runs.result("whole");
  EXPECT_EQ(result["flips"], 1);
  EXPECT_GT(result["quenches"], 0);
  EXPECT_GT(result["lists_built"], 5);
  EXPECT_GT(read_frames(runs.path("whole/frames.pvd")).size(), 7u)
      << "more than by steps and the start alone";
  const auto contacts = column(runs, "whole", "Contacts");
  EXPECT_TRUE(Checkpoints::read_newest(runs.path("start")).packing.contacts.empty());
  EXPECT_GT(contacts.back(), 50);
  const auto sliding = column(runs, "whole", "SlidingShare");
  EXPECT_TRUE(std::any_of(sliding.begin(), sliding.end(), [](double s) { return s > 0.1 && s < 0.95; }));
}

/// Every step ends a process, and every process begins where another has ended: in a chain of processes that
/// take one step each, and from each link of it straight to the end.
TEST(ReliableSplitRun, IsTheSameWhereverItIsSplit) {
  const HastyRuns runs;
  ASSERT_EQ(runs.run("whole").code, ExitCode::budget_spent);
  ASSERT_EQ(runs.run("chain", {"stop.steps=0"}).code, ExitCode::budget_spent);
  const std::string end = std::to_string(window);
  for (int step = 1; step <= window; ++step) {
    fs::copy(runs.path("chain"), runs.path("rest"), fs::copy_options::recursive);
    ASSERT_EQ(runs.resume("rest", {"--steps", end}).code, ExitCode::budget_spent) << step;
    ASSERT_EQ(difference(runs.path("whole"), runs.path("rest")), "")
        << "split after " << step - 1 << " steps";
    fs::remove_all(runs.path("rest"));
    const Answer link = runs.resume("chain", {"--steps", std::to_string(step)});
    ASSERT_EQ(link.code, ExitCode::budget_spent) << link.err;
  }
  EXPECT_EQ(difference(runs.path("whole"), runs.path("chain")), "");
}

/// Goes on from the older of the two checkpoints, that is, from behind what the files already hold.
TEST(ReliableSplitRun, FilesThatAreAheadAreCutBack) {
  const HastyRuns runs;
  ASSERT_EQ(runs.run("whole").code, ExitCode::budget_spent);
  ASSERT_EQ(runs.run("back", {"stop.steps=90"}).code, ExitCode::budget_spent);
  ASSERT_EQ(runs.resume("back", {"--steps", "250"}).code, ExitCode::budget_spent);
  const auto newest = Checkpoints::find_newest(runs.path("back"));
  ASSERT_EQ(newest.checkpoint.packing.step, 250);
  std::string bytes = content(runs.path("back/" + newest.file));
  bytes.resize(bytes.size() / 2);
  write_file(runs.path("back/" + newest.file), bytes);
  const Answer answer = runs.resume("back", {"--steps", "300"});
  ASSERT_EQ(answer.code, ExitCode::budget_spent);
  EXPECT_THAT(answer.err, testing::HasSubstr("continuing from the older checkpoint"));
  EXPECT_EQ(difference(runs.path("whole"), runs.path("back")), "");
}

/// Files that somebody has changed are not gone on with.
TEST(ReliableSplitRun, RefusesFilesThatAreNotItsOwn) {
  const HastyRuns runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=130"}).code, ExitCode::budget_spent);
  const std::pair<const char*, const char*> table[] = {{"a/history.csv", "\n7,"},
                                                       {"a/frames.pvd", "timestep=\""}};
  for (const auto& [name, before] : table) {
    const std::string good = content(runs.path(name));
    std::string changed = good;
    changed[changed.find(before) + std::strlen(before)] = '7';
    write_file(runs.path(name), changed);
    const Answer answer = runs.resume("a", {"--steps", "200"});
    EXPECT_EQ(answer.code, ExitCode::bad_case) << name;
    EXPECT_THAT(answer.err, testing::HasSubstr("restore the file"));
    write_file(runs.path(name), good);
  }
  EXPECT_EQ(runs.resume("a", {"--steps", "200"}).code, ExitCode::budget_spent);
}

/// A run that is told to go on after its verdict has nothing to do but to tell it again.
TEST(ReliableSplitRun, AVerdictIsFoundOnce) {
  const HastyRuns runs;
  const std::vector<std::string> set{"compaction.pressure=2e-2", "stop.steps=10_000"};
  ASSERT_EQ(runs.run("whole", set).code, ExitCode::done);
  ASSERT_EQ(runs.run("twice", set).code, ExitCode::done);
  fs::remove(runs.path("twice/result.json"));  // killed after the last checkpoint, say
  const Answer again = runs.resume("twice");
  EXPECT_EQ(again.code, ExitCode::done);
  EXPECT_THAT(again.out, testing::HasSubstr("verdict   jammed"));
  EXPECT_EQ(difference(runs.path("whole"), runs.path("twice")), "");
}

/// Between any two of its final quenches a run may be stopped.
TEST(ReliableSplitRun, IsTheSameBetweenItsFinalQuenches) {
  const HastyRuns runs;
  const std::vector<std::string> set{"compaction.pressure=2e-2", "stop.final_quenches=8"};
  const auto with_cap = [&](std::int64_t steps) {
    auto all = set;
    all.push_back("stop.steps=" + std::to_string(steps));
    return all;
  };
  ASSERT_EQ(runs.run("whole", with_cap(10'000)).code, ExitCode::done);
  ASSERT_EQ(runs.run("plain", {"compaction.pressure=2e-2", "stop.steps=10_000"}).code, ExitCode::done);
  const std::int64_t first = runs.result("plain")["steps"], last = runs.result("whole")["steps"];
  ASSERT_GE(runs.result("whole")["quenches"], 8);
  ASSERT_GT(last, first);
  for (std::int64_t step = first - 1; step < last; step += std::max<std::int64_t>((last - first) / 9, 1)) {
    ASSERT_EQ(runs.run("split", with_cap(step)).code, ExitCode::budget_spent) << step;
    ASSERT_EQ(runs.resume("split", {"--steps", "10000"}).code, ExitCode::done) << step;
    EXPECT_EQ(difference(runs.path("whole"), runs.path("split")), "") << step;
    fs::remove_all(runs.path("split"));
  }
}

/// Friction as in most runs, and a bound on phi that is soon small enough, though the cell is never as still
/// as asked.
constexpr const char* settling_case = R"([mixture]
large = 60
start_fraction = 0.3
[compaction]
pressure = 1e-3
[stop]
strain_drift = 1e-30
phi_error = 1e-2
[compute]
threads = 1
[output]
history_every = 500
picture = "none"
)";

/// phi of a settled run has a bound and is no phi_J; it may be carried on to rest.
TEST(ReliableSplitRun, ASettledRunIsToldAgainAndGoesOn) {
  const Runs runs(settling_case);
  const Answer answer = runs.run("whole");
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_THAT(answer.out,
              testing::HasSubstr("verdict   settled (phi can change by less than stop.phi_error)"));
  const auto result = runs.result("whole");
  EXPECT_EQ(result["verdict"], "settled");
  EXPECT_TRUE(result["phi_J"].is_null());
  EXPECT_GT(result["phi_bound"], 0);
  EXPECT_LT(result["phi_bound"], 1e-2);

  ASSERT_EQ(runs.run("twice").code, ExitCode::done);
  fs::remove(runs.path("twice/result.json"));
  ASSERT_EQ(runs.resume("twice").code, ExitCode::done);
  EXPECT_EQ(difference(runs.path("whole"), runs.path("twice")), "");

  const std::int64_t steps = result["steps"];
  const Answer on = runs.resume("twice", {"--phi-error", "0", "--steps", std::to_string(steps + 5000)});
  EXPECT_EQ(on.code, ExitCode::budget_spent) << on.err;
  EXPECT_EQ(runs.result("twice")["steps"], steps + 5000);
}

/// A packing that settles goes on to the next pressure, also in a process that began later.
TEST(ReliableSplitRun, SettlesAtOnePressureAfterTheOther) {
  const Runs runs(settling_case);
  const std::string pressures = "compaction.pressure=[4e-3, 1e-3]";
  ASSERT_EQ(runs.run("whole", {pressures}).code, ExitCode::done);
  const auto result = runs.result("whole"), states = result["resting_states"];
  EXPECT_EQ(result["verdict"], "settled");
  ASSERT_EQ(states.size(), 2u);
  for (const auto& state : states) {
    EXPECT_TRUE(state["phi_J"].is_null());
    EXPECT_GT(state["phi_bound"], 0);
    EXPECT_LT(state["phi_bound"], 1e-2);
  }
  EXPECT_EQ(states[0]["pressure"], 4e-3);
  EXPECT_LT(states[1]["phi"], states[0]["phi"]) << "the cell grows when the pressure falls";
  EXPECT_EQ(states[1]["phi"], result["phi"]);
  EXPECT_EQ(states[1]["phi_bound"], result["phi_bound"]);

  const std::int64_t first = states[0]["step"];
  ASSERT_EQ(runs.run("parts", {pressures, "stop.steps=" + std::to_string(first - 70)}).code,
            ExitCode::budget_spent);
  EXPECT_TRUE(runs.result("parts")["resting_states"].empty());
  ASSERT_EQ(runs.resume("parts", {"--steps", std::to_string(first + 130)}).code, ExitCode::budget_spent);
  EXPECT_EQ(runs.result("parts")["resting_states"], nlohmann::json::array({states[0]}));
  ASSERT_EQ(runs.resume("parts", {"--steps", "10000000"}).code, ExitCode::done);
  EXPECT_EQ(difference(runs.path("parts"), runs.path("whole")), "");
}

/// In single precision a radius is rounded when a run begins, and all that follows from it must follow from
/// the rounded one, which is all that a run that goes on knows.
TEST(ReliableSplitRun, SizesThatAreNoBinaryFractionsAreRoundedOnce) {
  std::string text = settling_case;
  text.erase(text.find("large = 60\n"), 11);  // which a list excludes
  const Runs runs(text);
  std::string list;
  for (int k = 0; k < 60; ++k) list += std::to_string(7.1 + 0.13 * k) + "\n";
  write_file(runs.path("sizes.txt"), list);
  const std::string listed = "mixture.diameters=" + runs.path("sizes.txt");
  const std::vector<std::vector<std::string>> mixtures{
      {"mixture.size_ratio=2.7", "mixture.small_fraction=0.3", "mixture.large=12"},
      {listed},
      {listed, "contact.friction=0", "compaction.mass_exponent=2"}};
  for (auto set : mixtures) {
    set.emplace_back("stop.steps=6000");
    ASSERT_NE(runs.run("whole", set).code, ExitCode::bad_case);
    set.back() = "stop.steps=2500";
    ASSERT_EQ(runs.run("part", set).code, ExitCode::budget_spent);
    ASSERT_NE(runs.resume("part", {"--steps", "6000"}).code, ExitCode::bad_case);
    EXPECT_EQ(difference(runs.path("whole"), runs.path("part")), "") << set[0];
    fs::remove_all(runs.path("whole"));
    fs::remove_all(runs.path("part"));
  }
}

/// A run that ends as settled, and one without friction that ends by the minimizer, each in processes of few
/// steps.
TEST(ReliableSplitRun, EndsAsTheWholeRunDoes) {
  for (const std::vector<std::string>& set :
       {std::vector<std::string>{}, {"contact.friction=0", "stop.strain_drift=1e-6", "stop.phi_error=0"}}) {
    const Runs runs(settling_case);
    ASSERT_EQ(runs.run("whole", set).code, ExitCode::done);
    const std::int64_t steps = runs.result("whole")["steps"];
    auto start = set;
    start.emplace_back("stop.steps=0");
    ASSERT_EQ(runs.run("chain", start).code, ExitCode::budget_spent);
    for (std::int64_t step = 700; step < steps; step += 700)
      ASSERT_EQ(runs.resume("chain", {"--steps", std::to_string(step)}).code, ExitCode::budget_spent);
    ASSERT_EQ(runs.resume("chain", {"--steps", "10000000"}).code, ExitCode::done);
    EXPECT_EQ(difference(runs.path("whole"), runs.path("chain")), "");
  }
}

}  // namespace
}  // namespace furnas
