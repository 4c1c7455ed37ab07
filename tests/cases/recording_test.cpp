#include "cases/recording.h"

#include <thread>

#include "tests/engine/fake_simulation.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

Packing at_step(std::int64_t step) {
  Packing p = random_packing(1, 8);
  p.step = step;
  return p;
}

void save(Checkpoints& checkpoints, std::int64_t step) {
  checkpoints.write(at_step(step), "", {}, RestWatch({}));
}

/// Steps of the two checkpoints, the smaller first; -1 for one that is missing.
std::pair<std::int64_t, std::int64_t> steps(const TemporaryFolder& folder) {
  const auto step = [&](const char* name) {
    return fs::exists(folder / name) ? read_checkpoint(folder / name).packing.step : -1;
  };
  return std::minmax({step("a.checkpoint"), step("b.checkpoint")});
}

using Steps = std::pair<std::int64_t, std::int64_t>;

TEST(Checkpoints, AreWrittenInTurn) {
  const TemporaryFolder folder;
  Checkpoints checkpoints(folder / "");
  EXPECT_TRUE(checkpoints.none());
  save(checkpoints, 10);
  EXPECT_FALSE(checkpoints.none());
  EXPECT_EQ(steps(folder), Steps(-1, 10));
  save(checkpoints, 20);
  EXPECT_EQ(steps(folder), Steps(10, 20));
  save(checkpoints, 30);
  EXPECT_EQ(steps(folder), Steps(20, 30));
  EXPECT_EQ(Checkpoints::read_newest(folder / "").packing.step, 30);
}

/// Who goes on must not begin by writing over the newest, whichever of the two that is.
TEST(Checkpoints, WhoGoesOnWritesOverTheOlder) {
  const TemporaryFolder folder;
  std::int64_t step = 0;
  for (int process = 0; process < 5; ++process) {
    Checkpoints checkpoints(folder / "");
    for (int n = 0; n < 1 + process % 2; ++n) {
      save(checkpoints, ++step);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));  // times of files are coarse
      if (step > 1) {
        EXPECT_EQ(steps(folder), Steps(step - 1, step));
      }
    }
  }
}

TEST(Checkpoints, KeepWhatTheRunMustRemember) {
  const TemporaryFolder folder;
  const std::vector<RestingState> reached{{0.1, 1.0 / 3, 7}, {1e-300, 2.0 / 3, 8}};
  RestWatch watch({});
  const double third = 1.0 / 3;
  watch.restore({{1000, {third, 2 * third, 4 * third, -third, 1e-17, -1e300}, true, false},
                 {2000, {1, 2, 3, 4, 5, 6}, false, true}});
  Checkpoints(folder / "").write(at_step(3), "text", reached, watch);
  const Checkpoint checkpoint = Checkpoints::read_newest(folder / "");
  EXPECT_EQ(checkpoint.case_text, "text");
  const std::vector<RestingState> states = resting_states_of(checkpoint);
  ASSERT_EQ(states.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(states[n].pressure, reached[n].pressure);
    EXPECT_EQ(states[n].phi, reached[n].phi);
    EXPECT_EQ(states[n].step, reached[n].step);
  }
  const std::deque<RestWatch::Look> window = window_of(checkpoint);
  ASSERT_EQ(window.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(window[n].step, watch.window()[n].step);
    EXPECT_EQ(window[n].edges, watch.window()[n].edges);
    EXPECT_EQ(window[n].holds, watch.window()[n].holds);
    EXPECT_EQ(window[n].holds_loosely, watch.window()[n].holds_loosely);
  }
  EXPECT_TRUE(window_of({}).empty());
  EXPECT_TRUE(resting_states_of({}).empty());
}

/// An event that saves at once, and what it works with.
struct Saving {
  explicit Saving(const Packing& packing) : simulation([packing](std::int64_t) { return packing; }) {}

  TemporaryFolder folder;
  FakeSimulation simulation;
  Observation now{simulation, 3};
  Checkpoints checkpoints{folder / ""};
  std::vector<RestingState> reached;
  RestWatch watch{RestCriteria{}};
  std::atomic<bool> asked{false};
  SaveCheckpoint event{checkpoints, "", reached, watch, 1e6, asked};
};

Packing calm() {
  Packing p = at_step(0);
  p.contacts.clear();
  p.cell.edges = {100, 100, 100, 0, 0, 0};
  for (std::size_t k = 0; k < p.size(); ++k) p.velocity[k] = p.spin[k] = {};
  return p;
}

TEST(SaveCheckpoint, SavesWhenAsked) {
  Saving saving(calm());
  EXPECT_TRUE(saving.event.heeds_attention());
  EXPECT_FALSE(saving.event.due(saving.now));
  saving.asked = true;
  EXPECT_TRUE(saving.event.due(saving.now));
  EXPECT_FALSE(saving.event.fire(saving.now).has_value());
  EXPECT_FALSE(saving.asked);
  EXPECT_EQ(saving.folder.files(), 1u);
}

/// A state that is none must not take the place of the last good one.
TEST(SaveCheckpoint, RefusesAStateThatHasDiverged) {
  Packing broken = calm();
  broken.velocity[3].y = std::numeric_limits<double>::quiet_NaN();
  Packing collapsed = calm();
  collapsed.cell.edges = {1, 1, 1, 0, 0, 0};
  for (const Packing& packing : {broken, collapsed}) {
    Saving saving(packing);
    EXPECT_EQ(saving.event.fire(saving.now), Verdict::diverged);
    EXPECT_EQ(saving.folder.files(), 0u);
  }
}

/// Frames after the checkpoint that a run goes on from are taken again, not kept twice.
TEST(RecordFrame, GoesOnAfterTheCheckpoint) {
  const TemporaryFolder folder;
  FakeSimulation simulation([](std::int64_t step) {
    Packing p = calm();
    p.time = 0.5 * static_cast<double>(step);
    return p;
  });
  Observation now(simulation, 3);
  const auto record = [&](double time, int frames) {
    RecordFrame event(folder / "", time, 10);
    for (int n = 0; n < frames; ++n) simulation.advance(10, nullptr), event.fire(now);
  };
  const auto times = [&] {
    std::vector<double> found;
    for (const SavedFrame& frame : read_frames(folder / "frames.pvd")) found.push_back(frame.time);
    return found;
  };
  record(0, 3);
  EXPECT_EQ(times(), (std::vector<double>{5, 10, 15}));
  record(10, 1);
  EXPECT_EQ(times(), (std::vector<double>{5, 10, 20}));
  record(0, 1);  // a fresh run counts its own
  EXPECT_EQ(times(), std::vector<double>{25});
}

}  // namespace
}  // namespace furnas
