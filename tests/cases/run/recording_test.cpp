#include "cases/program/run/recording.h"

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

void save(Checkpoints& checkpoints, std::int64_t step) { checkpoints.write({at_step(step), "", {}}); }

/// Steps of the two checkpoints, the smaller first; -1 for one that is missing.
std::pair<std::int64_t, std::int64_t> steps(const TemporaryFolder& folder) {
  const auto step = [&](const char* name) {
    return fs::exists(folder / name) ? read_checkpoint(folder / name).packing.step : -1;
  };
  return std::minmax({step("a.checkpoint"), step("b.checkpoint")});
}

using Steps = std::pair<std::int64_t, std::int64_t>;

TEST(ReliableCheckpoints, AreWrittenInTurn) {
  const TemporaryFolder folder;
  Checkpoints checkpoints(folder / "");
  save(checkpoints, 10);
  EXPECT_EQ(steps(folder), Steps(-1, 10));
  save(checkpoints, 20);
  EXPECT_EQ(steps(folder), Steps(10, 20));
  save(checkpoints, 30);
  EXPECT_EQ(steps(folder), Steps(20, 30));
  EXPECT_EQ(Checkpoints::read_newest(folder / "").packing.step, 30);
  EXPECT_GT(checkpoints.longest().count(), 0);
}

/// Who goes on must not begin by writing over the newest, whichever of the two that is.
TEST(ReliableCheckpoints, WhoGoesOnWritesOverTheOlder) {
  const TemporaryFolder folder;
  std::int64_t step = 0;
  {
    Checkpoints checkpoints(folder / "");
    save(checkpoints, ++step);
  }
  for (int process = 0; process < 5; ++process) {
    const auto found = Checkpoints::find_newest(folder / "");
    Checkpoints checkpoints(folder / "", found.file, found.seconds);
    for (int n = 0; n < 1 + process % 2; ++n) {
      save(checkpoints, ++step);
      EXPECT_EQ(steps(folder), Steps(step - 1, step));
    }
  }
}

/// The good one of two stays, too, when it is the older.
TEST(ReliableCheckpoints, WhoGoesOnWritesOverTheDamaged) {
  for (const char* damaged : {"a.checkpoint", "b.checkpoint"}) {
    const TemporaryFolder folder;
    Checkpoints checkpoints(folder / "");
    for (int step : {10, 20, 30}) save(checkpoints, step);
    std::string bytes = content(folder / damaged);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_file(folder / damaged, bytes);
    const auto found = Checkpoints::find_newest(folder / "");
    EXPECT_NE(found.file, damaged);
    const bool newer = std::string(damaged) == "a.checkpoint";
    EXPECT_EQ(found.fault.find(damaged) != std::string::npos, newer) << found.fault;
    EXPECT_EQ(found.fault.empty(), !newer);
    Checkpoints next(folder / "", found.file, found.seconds);
    save(next, 40);
    EXPECT_EQ(steps(folder), Steps(found.checkpoint.packing.step, 40));
  }
}

/// An event that saves at once, and what it works with.
struct Saving {
  explicit Saving(const Packing& packing) : simulation([packing](std::int64_t) { return packing; }) {}

  TemporaryFolder folder;
  FakeSimulation simulation;
  Observation now{simulation, 3};
  Checkpoints checkpoints{folder / ""};
  std::atomic<bool> asked{false}, attention{false};
  SaveCheckpoint event{[this] { checkpoints.write({now.packing(), "", {}}); }, 1e5, asked, attention};
};

Packing calm() {
  Packing p = at_step(0);
  p.contacts.clear();
  p.cell.edges = {100, 100, 100, 0, 0, 0};
  for (std::size_t k = 0; k < p.size(); ++k) p.velocity[k] = p.spin[k] = {};
  return p;
}

TEST(ReliableSaveCheckpoint, SavesWhenAsked) {
  Saving saving(calm());
  EXPECT_TRUE(saving.event.heeds_attention());
  EXPECT_FALSE(saving.event.due(saving.now));
  saving.asked = true;
  EXPECT_TRUE(saving.event.due(saving.now));
  EXPECT_FALSE(saving.event.fire(saving.now).has_value());
  EXPECT_FALSE(saving.asked);
  EXPECT_EQ(saving.folder.files(), 1u);
}

/// A state that is none must not take the place of the last good one; that it ends the run is the Monitor's
/// say.
TEST(ReliableSaveCheckpoint, DoesNotSaveAStateThatHasDiverged) {
  Packing broken = calm();
  broken.velocity[3].y = std::numeric_limits<double>::quiet_NaN();
  Packing collapsed = calm();
  collapsed.cell.edges = {1, 1, 1, 0, 0, 0};
  for (const Packing& packing : {broken, collapsed}) {
    Saving saving(packing);
    EXPECT_FALSE(saving.event.fire(saving.now).has_value());
    EXPECT_EQ(saving.folder.files(), 0u);
  }
}

/// However long a step takes, a checkpoint is not later than its period.
TEST(ReliableSaveCheckpoint, CallsTheRunToAttention) {
  Saving saving(calm());
  SaveCheckpoint soon(
      [&] {
        saving.checkpoints.write({saving.now.packing(), "", {}});
      },
      1e-3, saving.asked, saving.attention);
  const auto begin = std::chrono::steady_clock::now();
  while (!saving.attention && std::chrono::steady_clock::now() - begin < std::chrono::seconds(20))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(saving.attention);
  EXPECT_TRUE(soon.due(saving.now));
  soon.fire(saving.now);
  EXPECT_EQ(saving.folder.files(), 1u);
}

/// Frames after the checkpoint that a run goes on from are taken again, not kept twice.
TEST(ReliableRecordFrame, GoesOnAfterTheCheckpoint) {
  const TemporaryFolder folder;
  FakeSimulation simulation([](std::int64_t step) {
    Packing p = calm();
    p.time = 0.5 * static_cast<double>(step);
    return p;
  });
  Observation now(simulation, 3);
  const auto record = [&](const std::string& saved, int frames) {
    RecordFrame event(folder / "", {.steps = 10});
    event.restore(saved);
    for (int n = 0; n < frames; ++n) simulation.advance(10, nullptr), event.fire(now);
    return event.saved();
  };
  const auto times = [&] {
    std::vector<double> found;
    for (const SavedFrame& frame : read_frames(folder / "frames.pvd")) found.push_back(frame.time);
    return found;
  };
  const std::string two = record("", 2);
  EXPECT_EQ(times(), (std::vector<double>{5, 10}));
  record(two, 2);
  EXPECT_EQ(times(), (std::vector<double>{5, 10, 15, 20}));
  EXPECT_TRUE(fs::exists(folder / frame_file(3)));
  EXPECT_EQ(record(two, 0), two);
  EXPECT_EQ(times(), (std::vector<double>{5, 10}));
  EXPECT_FALSE(fs::exists(folder / frame_file(2)));
  record(two, 1);
  EXPECT_EQ(times(), (std::vector<double>{5, 10, 25}));
  write_file(folder / "frames.pvd", frames_text({{5, frame_file(0)}}));
  EXPECT_NE(input_error([&] { record(two, 0); }).find("restore the file"), std::string::npos);
  EXPECT_EQ(record("", 0), "");  // a fresh run has none
  EXPECT_FALSE(fs::exists(folder / "frames.pvd") || fs::exists(folder / frame_file(0)));
}

}  // namespace
}  // namespace furnas
