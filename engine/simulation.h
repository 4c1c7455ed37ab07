#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

#include "engine/graph/step_graph.h"
#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// How many pairs a step tests for contact.
struct NeighbourCounts {
  std::int64_t builds{};      ///< neighbour lists built so far
  std::size_t pairs{};        ///< pairs in the neighbour list
  std::size_t inner_pairs{};  ///< pairs that most steps test: the inner list, or all without one
};

/// A packing in motion: owns the state and the step. Law and precision are chosen by make_simulation() and
/// hidden behind this class.
///
/// Only one thread at a time may call members of a simulation, and none may be called while advance() runs.
/// advance() uses threads of its own. Several simulations may run side by side. Costs below are given in
/// passes over all particles and contacts; a step costs about two passes.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Takes up to `steps` timesteps; fewer if `stop` becomes true. `stop` is read after each step, and any
  /// thread may set it. Throws NumericalFailure if the cell collapses.
  virtual void advance(std::int64_t steps, const std::atomic<bool>* stop = nullptr) = 0;

  /// The packing as it is now, with its contacts: a copy, made in one pass. It takes about 300 bytes per
  /// particle and 160 per contact.
  virtual Packing packing() const = 0;

  /// Replaces the packing by another one. A packing with an `order` continues with its forces and histories.
  /// A packing without an order is a start: its particles are sorted, and its forces are computed from the
  /// positions, without history. In both cases a neighbour list is built, which takes as long as about ten
  /// steps. Throws InputError for a packing that is not valid, and NumericalFailure for a collapsed cell;
  /// after that the packing can be read, but not advanced.
  virtual void load(const Packing& packing) = 0;

  /// Sets the velocities [d_s/time] and spins [1/time] of all particles, in order of id, and the strain rate
  /// of the cell [1/time]. Positions, forces, histories, stress and neighbour list stay. The ledger books the
  /// kinetic energy that the particles lose as quenched. Costs one pass over the particles.
  virtual void set_motion(std::span<const Vec3<double>> velocity, std::span<const Vec3<double>> spin,
                          const Triangle& rate) = 0;

  /// Sets another bath; which deformations the cell may make does not change.
  virtual void set_bath(const Barostat& bath) = 0;

  virtual std::int64_t step() const = 0;   ///< steps since the start
  virtual const Cell& cell() const = 0;    ///< as it is now
  virtual const Model& model() const = 0;  ///< with the present bath and time step

  /// Number of threads that advance() uses.
  virtual int threads() const = 0;

  /// How many pairs a step tests now.
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

/// A simulation of `model` that starts from `packing`. Throws InputError for a packing that is not valid
/// (engine/state/validate.h), and for a cell so thin that spheres touch across thirty cells.
std::unique_ptr<Simulation> make_simulation(const Model& model, const Packing& packing, int threads = 1,
                                            Execution execution = Execution::automatic);

/// Number of threads that is worthwhile for a packing of this size.
int threads_for(std::size_t particles);

}  // namespace furnas
