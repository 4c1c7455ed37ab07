#include "cases/program/run/continuation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "io/case_file.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::HasSubstr;

Continuation example() {
  Continuation c;
  c.reached = {{0.1, 1.0 / 3, 7, 13.0 / 3, 1, 2}, {1e-300, 2.0 / 3, 8, 14.0 / 3, 3, 4, 1.0 / 7}};
  const double third = 1.0 / 3;
  c.watch.window = {{1000, {third, 2 * third, 4 * third, -third, 1e-17, -1e300}, true, false},
                    {2000, {1, 2, 3, 4, 5, 6}, false, true}};
  c.watch.backbone = 5;
  c.watch.force_imbalance = std::nan("");
  c.watch.stress_error = third;
  c.events = {{"flip", "3"}, {"history", std::string("a\0b", 3)}};
  c.replaced = 9;
  c.lists_built = 11;
  c.wall_seconds = 1.25;
  c.cpu_seconds = 2.5;
  c.ended = Verdict::settled;
  return c;
}

Checkpoint checkpoint_of(const Continuation& c) {
  return {random_packing(1), resolved_toml({}), to_extras(c)};
}

TEST(ReliableContinuation, KeepsEveryBit) {
  const Continuation a = example();
  const Continuation b = continuation_of(checkpoint_of(a));
  ASSERT_EQ(b.reached.size(), 2u);
  ASSERT_EQ(b.watch.window.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(b.reached[n].pressure, a.reached[n].pressure);
    EXPECT_EQ(b.reached[n].phi, a.reached[n].phi);
    EXPECT_EQ(b.reached[n].step, a.reached[n].step);
    EXPECT_EQ(b.reached[n].Z_backbone, a.reached[n].Z_backbone);
    EXPECT_EQ(b.reached[n].large_rattlers, a.reached[n].large_rattlers);
    EXPECT_EQ(b.reached[n].small_rattlers, a.reached[n].small_rattlers);
    EXPECT_EQ(b.reached[n].phi_bound, a.reached[n].phi_bound);
    EXPECT_EQ(b.watch.window[n].step, a.watch.window[n].step);
    EXPECT_EQ(b.watch.window[n].edges, a.watch.window[n].edges);
    EXPECT_EQ(b.watch.window[n].holds, a.watch.window[n].holds);
    EXPECT_EQ(b.watch.window[n].holds_loosely, a.watch.window[n].holds_loosely);
  }
  EXPECT_EQ(b.watch.backbone, 5);
  EXPECT_EQ(b.watch.stress_error, a.watch.stress_error);
  EXPECT_TRUE(std::isnan(b.watch.force_imbalance));
  EXPECT_EQ(b.watch.kinetic_energy, RestReport::unknown);
  EXPECT_EQ(b.events, a.events);
  EXPECT_EQ(b.replaced, 9);
  EXPECT_EQ(b.lists_built, 11);
  EXPECT_EQ(b.wall_seconds, 1.25);
  EXPECT_EQ(b.cpu_seconds, 2.5);
  EXPECT_EQ(b.ended, Verdict::settled);
}

TEST(ReliableContinuation, MustBeWhole) {
  for (const auto& [key, value] : to_extras(example())) {
    if (key.starts_with("event: ")) continue;
    Checkpoint missing = checkpoint_of(example());
    missing.extras.erase(key);
    const std::string message = input_error([&] { continuation_of(missing); });
    if (key == "cpu seconds") {  // the first checkpoints of this version do not say them
      EXPECT_TRUE(std::isnan(continuation_of(missing).cpu_seconds));
    } else if (!key.starts_with("resting") && !key.starts_with("bounds")) {
      EXPECT_NE(message, "") << key;
    }
    Checkpoint wrong = checkpoint_of(example());
    wrong.extras[key] += " x";
    EXPECT_NE(input_error([&] { continuation_of(wrong); }), "") << key;
  }
  EXPECT_TRUE(resting_states_of({}).empty());
}

TEST(ReliableContinuation, RefusesAnotherVersion) {
  Checkpoint checkpoint = checkpoint_of(example());
  checkpoint.extras["version of furnas"] = "0.0.1";
  EXPECT_THAT(input_error([&] { continuation_of(checkpoint); }),
              HasSubstr("was written by furnas 0.0.1 and this is"));
}

TEST(ReliableContinuation, RefusesAnotherCase) {
  const TemporaryFolder folder;
  const Checkpoint checkpoint = checkpoint_of({});
  const auto asked = [&](auto change) {
    Case c;
    change(c);
    write_file(folder / "case.resolved.toml", resolved_toml(c));
    return input_error([&] { case_to_go_on_with(folder / "", checkpoint, {}); });
  };
  EXPECT_EQ(asked([](Case&) {}), "");
  EXPECT_THAT(asked([](Case& c) { c.contact.friction = 0.125; }),
              HasSubstr("contact.friction = 0.125, but the checkpoint was saved with 0.3"));
  EXPECT_THAT(asked([](Case& c) { c.mixture.seed = 2; }), HasSubstr("mixture.seed = 2"));
  EXPECT_THAT(asked([](Case& c) { c.compaction.time_step_absolute = 0.01; }),
              HasSubstr("compaction.time_step"));
  EXPECT_EQ(asked([](Case& c) { c.compute.threads = 3, c.stop.steps = 5, c.compute.skin = 0.1; }), "");
  const std::vector<std::string> set{"compute.threads=2"};
  const Case c = case_to_go_on_with(folder / "", checkpoint, set);
  EXPECT_EQ(c.stop.steps, 5) << "what an earlier resume was asked for";
  EXPECT_EQ(c.compute.threads, 2);
}

}  // namespace
}  // namespace furnas
