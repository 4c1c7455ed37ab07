#include <benchmark/benchmark.h>

#include "engine/certificate/overlaps.h"
#include "engine/monitor/measure.h"
#include "engine/search/size_classes.h"
#include "engine/simulation.h"
#include "engine/state/fingerprint.h"
#include "tests/benchmarks/dense_packing.h"

namespace furnas {
namespace {

const Simulation& dense_simulation() {
  static const auto simulation =
      make_simulation(model_with(HookeSynchronized{{.friction = 0.3}}), dense_packing());
  return *simulation;
}

/// Times `work` on the packing with its contacts.
template <class Work>
void on_the_packing(benchmark::State& state, Work work) {
  const Packing packing = dense_simulation().packing();
  for (auto _ : state) benchmark::DoNotOptimize(work(packing));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(packing.size()));
}

void packing_taken_out(benchmark::State& state) {
  on_the_packing(state, [](const Packing&) { return dense_simulation().packing(); });
}
void packing_measured(benchmark::State& state) {
  constexpr int backbone_threshold = 3;
  on_the_packing(state, [](const Packing& packing) { return measure(packing, backbone_threshold); });
}
void packing_hashed(benchmark::State& state) { on_the_packing(state, state_hash); }
void packing_ordered(benchmark::State& state) { on_the_packing(state, memory_order); }
void packing_overlaps(benchmark::State& state) { on_the_packing(state, find_overlaps); }
void packing_replicated(benchmark::State& state) {
  on_the_packing(state, [](const Packing& packing) { return replicate(packing, {2, 1, 1}); });
}

BENCHMARK(packing_taken_out);
BENCHMARK(packing_measured);
BENCHMARK(packing_hashed);
BENCHMARK(packing_ordered);
BENCHMARK(packing_overlaps);
BENCHMARK(packing_replicated);

}  // namespace
}  // namespace furnas
