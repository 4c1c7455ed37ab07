#pragma once

#include <functional>

#include "engine/base/require.h"
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
  void set_pressure(double pressure) override { model_.barostat.pressure = pressure; }
  int threads() const override { return 1; }
  std::int64_t builds() const override { return 17; }
  std::size_t pairs() const override { return 0; }
  std::size_t inner_pairs() const override { return 0; }
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
