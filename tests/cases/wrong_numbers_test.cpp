#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "cases/program/run/recording.h"
#include "engine/events/limits.h"
#include "engine/events/monitor.h"
#include "tests/engine/support/compaction.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

constexpr std::int64_t poisoned_at = 500;  // a step with contacts
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Puts a wrong number into the packing at a step.
class Poison final : public Event {
 public:
  using Change = std::function<void(Packing&)>;

  explicit Poison(Change change) : change_(std::move(change)) {}
  const char* name() const override { return "poison"; }
  std::int64_t next(std::int64_t step) const override {
    return step < poisoned_at ? poisoned_at : std::numeric_limits<std::int64_t>::max();
  }
  std::optional<Verdict> fire(Observation& now) override {
    Packing packing = now.packing();
    change_(packing);
    now.replace(packing);
    return {};
  }

 private:
  Change change_;
};

/// Asks for a checkpoint at every step that may have one, and at odd ones.
class Ask final : public Event {
 public:
  explicit Ask(std::atomic<bool>& asked) : asked_(asked) {}
  const char* name() const override { return "ask"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 100); }
  std::optional<Verdict> fire(Observation&) override {
    asked_ = true;
    return {};
  }

 private:
  std::atomic<bool>& asked_;
};

struct Story {
  std::string fault;     ///< what the run said when it stopped; empty if it did not stop
  std::int64_t step{};   ///< where it stopped
  std::int64_t saved{};  ///< step of the newest checkpoint
};

Story run_with(const Poison::Change& change) {
  const TemporaryFolder folder;
  const auto simulation = make_simulation(test::hasty_model(0.3), test::hasty_gas(6));
  Observation now(*simulation, 3);
  Checkpoints checkpoints(folder / "");
  std::atomic<bool> asked{false}, attention{false};
  Events events;
  events.push_back(std::make_unique<Monitor>());
  events.push_back(std::make_unique<Poison>(change));
  events.push_back(std::make_unique<Ask>(asked));
  events.push_back(std::make_unique<SaveCheckpoint>(
      [&] {
        checkpoints.write({now.packing(), "", {}});
      },
      1e5, asked, attention));
  events.push_back(std::make_unique<Budget>(3000));
  Story story;
  try {
    if (compact(now, events, &attention) == Verdict::diverged) story.fault = now.fault();
  } catch (const NumericalFailure& error) {
    story.fault = error.what();
  }
  story.step = now.step();
  story.saved = Checkpoints::read_newest(folder / "").packing.step;
  return story;
}

/// Whatever number goes wrong in whatever array: the next check stops the run, says why, and no checkpoint
/// ever holds it.
TEST(ReliableNumbers, AWrongOneReachesNoCheckpoint) {
  const std::pair<const char*, Poison::Change> table[] = {
      {"velocity", [](Packing& p) { p.velocity[5].x = nan; }},
      {"velocity", [](Packing& p) { p.velocity[5].x = infinity; }},
      {"spin", [](Packing& p) { p.spin[5].y = -infinity; }},
      {"force", [](Packing& p) { p.force[7].z = nan; }},
      {"torque", [](Packing& p) { p.torque[7].z = nan; }},
      {"history of a contact", [](Packing& p) { p.contacts.at(3).history.x = nan; }},
      {"history of a contact", [](Packing& p) { p.contacts.at(3).history.x = infinity; }},
      {"edge of the cell", [](Packing& p) { p.cell.edges.xy = nan; }},
      {"rate of the cell", [](Packing& p) { p.cell.rate.yy = nan; }},
      {"rate of the cell", [](Packing& p) { p.cell.rate.yz = infinity; }},
      {"stress of contacts", [](Packing& p) { p.stress.contacts(1, 1) = nan; }},
      {"stress of motion", [](Packing& p) { p.stress.motion(0, 2) = nan; }},
      {"ledger", [](Packing& p) { p.ledger.cell_work = nan; }},
      {"radius", [](Packing& p) { p.radius[2] = nan; }},
      {"mass", [](Packing& p) { p.mass[2] = infinity; }},
  };
  for (const auto& [name, change] : table) {
    const Story story = run_with(change);
    EXPECT_NE(story.fault, "") << name;
    EXPECT_LE(story.step, 1000) << name << ": the monitor looks every 1000 steps";
    EXPECT_LT(story.saved, poisoned_at) << name;
    EXPECT_GE(story.saved, poisoned_at - 100) << name;
  }
  EXPECT_EQ(run_with([](Packing&) {}).fault, "") << "without poison it goes on";
}

/// A number that the next step makes anew is not saved where it is wrong, and does not end the run because
/// somebody looked just then.
TEST(ReliableNumbers, OneThatHealsEndsNoRun) {
  const Story story = run_with([](Packing& p) { p.contacts.at(3).force.x = nan; });
  EXPECT_EQ(story.fault, "");
  EXPECT_EQ(story.saved, 3000);
}

/// A number that is one, but beyond all bounds, becomes none within a step or two. The older checkpoint
/// stays.
TEST(ReliableNumbers, AnAbsurdOneIsFoundBeforeTheOlderCheckpointGoes) {
  for (const Poison::Change& change : std::initializer_list<Poison::Change>{
           [](Packing& p) { p.velocity[5].x = 1e200; }, [](Packing& p) { p.spin[5].y = 1e300; },
           [](Packing& p) { p.force[7].z = 1e300; }}) {
    const Story story = run_with(change);
    EXPECT_NE(story.fault, "");
    EXPECT_LE(story.step, 1000);
    EXPECT_LE(story.saved, poisoned_at);
  }
}

}  // namespace
}  // namespace furnas
