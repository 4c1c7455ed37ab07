#pragma once

#include <functional>

#include "engine/base/require.h"
#include "engine/monitor/energy.h"
#include "engine/simulation.h"

namespace furnas {

/// A simulation whose packing at each step is made up, for events that only look.
class FakeSimulation : public Simulation {
 public:
  using Story = std::function<Packing(std::int64_t step)>;

  explicit FakeSimulation(Story story) : story_(std::move(story)) {}

  void advance(std::int64_t steps, const std::atomic<bool>* stop) override {
    for (std::int64_t n = 0; n < steps && !(stop && *stop); ++n) ++step_;
  }
  Packing packing() const override {
    ++packings_taken;
    Packing p = loaded_ ? *loaded_ : story_(step_);
    p.step = step_;
    return p;
  }
  void load(const Packing& packing) override { loaded_ = packing; }
  std::int64_t step() const override { return step_; }
  const Cell& cell() const override { return cell_; }
  const Model& model() const override { return model_; }
  void set_motion(std::span<const Vec3<double>> velocity, std::span<const Vec3<double>> spin,
                  const Triangle& rate) override {
    Packing changed = packing();
    for (std::size_t k = 0; k < changed.size(); ++k) changed.ledger.quenched += kinetic_energy(changed, k);
    changed.velocity.assign(velocity.begin(), velocity.end());
    changed.spin.assign(spin.begin(), spin.end());
    for (std::size_t k = 0; k < changed.size(); ++k) changed.ledger.quenched -= kinetic_energy(changed, k);
    changed.cell.rate = rate;
    loaded_ = changed;
  }
  void set_bath(const Barostat& bath) override { model_.barostat = bath; }
  int threads() const override { return 1; }
  NeighbourCounts neighbours() const override { return {.builds = 17}; }
  const StepGraph& graph() const override { throw ContractError("a made-up simulation has no phases"); }

  Model& model() { return model_; }

  mutable int packings_taken = 0;

 private:
  Story story_;
  std::int64_t step_ = 0;
  Cell cell_;
  Model model_;
  std::optional<Packing> loaded_;
};

}  // namespace furnas
