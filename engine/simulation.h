#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

#include "engine/graph/step_graph.h"
#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// How many pairs a step looks at.
struct NeighbourCounts {
  std::int64_t builds{};      ///< neighbour lists built so far
  std::size_t pairs{};        ///< pairs in the neighbour list
  std::size_t inner_pairs{};  ///< pairs that most steps look at: those of the inner list, or all without one
};

/// A packing in motion: owns the state and the step. Law and precision are chosen when it is made and hidden
/// behind this class.
///
/// Only one thread at a time may call a simulation, and calls no member while advance() runs; advance() uses
/// threads of its own. Several simulations may run side by side. Costs are in passes over particles and
/// contacts; a step is about two.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Takes up to `steps` timesteps; fewer if `stop` becomes true, which is looked at after each; any thread
  /// may set it. Throws NumericalFailure if the cell collapses.
  virtual void advance(std::int64_t steps, const std::atomic<bool>* stop = nullptr) = 0;

  /// The packing as it is now, with its contacts: a copy, made in one pass, of some 300 bytes a particle and
  /// 160 a contact.
  virtual Packing packing() const = 0;

  /// Puts another packing in the place of this one. A packing with an `order` continues where it was, with
  /// its forces and histories; a packing without is a start: its forces are taken from the positions, without
  /// history. Sorts the particles if they have no order, and builds a neighbour list: as long as some ten
  /// steps. Throws InputError for a packing that is none.
  virtual void load(const Packing& packing) = 0;

  /// Puts other velocities [d_s/time] and spins [1/time], in order of id, and another strain rate of the cell
  /// [1/time] in the place of the present ones. Positions, forces, histories, stress and neighbour list stay.
  /// The ledger books as quenched the kinetic energy that this takes out of the particles. Costs a pass over
  /// the particles.
  virtual void set_motion(std::span<const Vec3<double>> velocity, std::span<const Vec3<double>> spin,
                          const Triangle& rate) = 0;

  /// Steps are as long as this from now on [time]; the time of the packing goes on from where it is.
  virtual void set_time_step(double time_step) = 0;

  /// Turns to another bath; the deformations that the cell may make stay what they are.
  virtual void set_bath(const Barostat& bath) = 0;

  virtual std::int64_t step() const = 0;   ///< steps since the start
  virtual const Cell& cell() const = 0;    ///< as it is now
  virtual const Model& model() const = 0;  ///< with the present bath and time step

  /// Threads that it runs on.
  virtual int threads() const = 0;

  /// How many pairs a step looks at now.
  virtual NeighbourCounts neighbours() const = 0;

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
