#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

double quantile(std::vector<double> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// A cell too heavy to move, though all phases of one that moves are run.
Model unmoved_cell() {
  Model model = model_with(HookeSynchronized{{.friction = 0.3}});
  model.precision = Precision::mixed;
  model.barostat.inertia = 1e300;
  return model;
}

/// 500 equal spheres that have come to rest, repeated.
Packing resting(const Times& times) {
  static const Packing packing = [] {
    const auto simulation = make_simulation(unmoved_cell(), mono({1, 1, 1}));
    simulation->advance(5000);
    return simulation->packing();
  }();
  return replicate(packing, times);
}

/// A step of these two is nothing but calls.
Packing two_spheres() {
  Packing packing = mono({1, 1, 1});
  packing.resize(2);
  return packing;
}

/// The same steps in order and as a graph, a few of one and then of the other: microseconds that a step takes
/// (median, and the tenth that other programs disturbed least), and how much longer a step takes as a graph
/// than in order in a pair (median and quartiles).
void graph_against_order(benchmark::State& state, const Packing& packing, int threads) {
  const auto steps = std::clamp<std::int64_t>(20000 / static_cast<std::int64_t>(packing.size()), 1, 300);
  const std::unique_ptr<Simulation> simulations[] = {
      make_simulation(unmoved_cell(), packing, threads, Execution::in_order),
      make_simulation(unmoved_cell(), packing, threads, Execution::as_graph)};
  for (const auto& simulation : simulations) simulation->advance(200);  // past the first list, which is wide
  std::vector<double> microseconds[2];
  std::vector<double> ratios;
  for (auto _ : state) {
    for (std::size_t n = 0; n < 2; ++n) {
      const std::size_t which = (n + ratios.size()) % 2;
      const auto begin = std::chrono::steady_clock::now();
      simulations[which]->advance(steps);
      const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - begin;
      microseconds[which].push_back(taken.count() / static_cast<double>(steps));
    }
    ratios.push_back(microseconds[1].back() / microseconds[0].back());
  }
  for (const std::size_t which : {0, 1}) {
    const std::string name = which == 0 ? "order" : "graph";
    state.counters[name + "_us"] = quantile(microseconds[which], 0.5);
    state.counters[name + "_us_best_tenth"] = quantile(microseconds[which], 0.1);
  }
  state.counters["ratio"] = quantile(ratios, 0.5);
  state.counters["ratio_low"] = quantile(ratios, 0.25);
  state.counters["ratio_high"] = quantile(ratios, 0.75);
}

const bool pairs_registered = [] {
  for (const int threads : {1, 2})
    for (const auto& [spheres, packing] : {std::pair<const char*, Packing (*)()>{"2", two_spheres},
                                           {"1000",
                                            [] {
                                              return resting({2, 1, 1});
                                            }},
                                           {"10000", [] {
                                              return resting({5, 2, 2});
                                            }}})
      benchmark::RegisterBenchmark(
          ("step/graph_against_order/" + std::string(spheres) + "/threads:" + std::to_string(threads))
              .c_str(),
          [start = packing, threads](benchmark::State& state) {
            graph_against_order(state, start(), threads);
          })
          ->UseRealTime();
  return true;
}();

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
