#include <benchmark/benchmark.h>

#include <optional>
#include <string>

#include "engine/simulation.h"
#include "tests/benchmarks/dense_packing.h"

namespace furnas {
namespace {

/// Whole steps, and beside their time that of each phase, in seconds per particle and step. Written against
/// the graph alone, so that it stays right when phases come, go or change.
void step(benchmark::State& state, const Model& model) {
  const auto simulation = make_simulation(model, dense_packing());
  std::vector<PhaseTime> times;
  simulation->graph().keep_times(&times);
  for (auto _ : state) simulation->advance(1);
  const std::vector<std::string> titles = simulation->graph().titles();
  const auto particle_steps =
      static_cast<double>(state.iterations()) * static_cast<double>(dense_packing().size());
  for (std::size_t k = 0; k < titles.size(); ++k)
    state.counters[titles[k]] += benchmark::Counter(times[k].seconds / particle_steps);
  state.SetItemsProcessed(static_cast<std::int64_t>(particle_steps));
}

/// Each law in each precision, with the list that stands for many steps, and with one that is built in every
/// step.
const bool registered = [] {
  constexpr HookeConstants with_friction{.friction = 0.3}, without_friction{};
  const std::pair<const char*, AnyLaw> laws[] = {
      {"hooke_synchronized", HookeSynchronized{with_friction}},
      {"hooke_history", HookeHistory{with_friction}},
      {"frictionless", Frictionless<false>{without_friction}},
  };
  for (const auto& [name, law] : laws) {
    for (const Precision precision : {Precision::mixed, Precision::full}) {
      const std::string variant = std::string(name) + (precision == Precision::mixed ? "/mixed" : "/double");
      Model model = model_with(law);
      model.precision = precision;
      benchmark::RegisterBenchmark(("step/standing_list/" + variant).c_str(), step, model);
      model.skin = 0;
      benchmark::RegisterBenchmark(("step/renewed_list/" + variant).c_str(), step, model);
    }
  }
  return true;
}();

}  // namespace
}  // namespace furnas
