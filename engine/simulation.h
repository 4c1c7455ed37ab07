#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "engine/graph/step_graph.h"
#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// A packing in motion: owns the state and the step. Law and precision are chosen when it is made and
/// hidden behind this class.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Takes up to `steps` timesteps; fewer if `stop` becomes true, which is looked at after each.
  virtual void advance(std::int64_t steps, const std::atomic<bool>* stop = nullptr) = 0;

  /// The packing as it is now, with its contacts.
  virtual Packing packing() const = 0;

  /// Puts another packing in the place of this one. One with an `order` continues where it was, with its
  /// forces and histories; one without is a start: its forces are taken from the positions, without history.
  virtual void load(const Packing& packing) = 0;

  virtual std::int64_t step() const = 0;
  virtual const Cell& cell() const = 0;
  virtual const Model& model() const = 0;

  /// Changes the pressure of the bath [k_n/d_s].
  virtual void set_pressure(double pressure) = 0;

  /// Threads that it runs on.
  virtual int threads() const = 0;

  /// Neighbour lists built so far.
  virtual std::int64_t builds() const = 0;

  /// Candidate pairs in the list.
  virtual std::size_t pairs() const = 0;

  /// Pairs of the list that most steps look at: those of the inner list, or all where there is none.
  virtual std::size_t inner_pairs() const = 0;

  /// The step as a graph.
  virtual const StepGraph& graph() const = 0;
};

/// How the phases of a step are run.
enum class Execution {
  automatic,  ///< as a graph when there are several threads
  in_order,
  as_graph
};

/// A simulation of `model` that starts from `packing`. Throws InputError with the ids when particles are
/// not finite, have no size, or share a centre.
std::unique_ptr<Simulation> make_simulation(const Model& model, const Packing& packing, int threads = 1,
                                            Execution execution = Execution::automatic);

/// Threads that pay for a packing of this size.
int threads_for(std::size_t particles);

}  // namespace furnas
