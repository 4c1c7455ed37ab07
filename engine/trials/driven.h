#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/phases/forces.h"
#include "engine/phases/integrate.h"
#include "engine/trials/listed.h"

namespace furnas {

/// Few particles in a fixed cell, with an additional external force on each particle, such as gravity or a
/// spring. The engine has no external forces. Therefore this class has a step of its own, which calls the
/// phases of `engine/step.cpp` except those for the cell and the neighbour list: every pair is listed from
/// the start.
template <class Law>
class Driven {
 public:
  using S = Numerics<Law, double>;

  /// External force on particle k at a position and a time [k_n d_s].
  using Push = std::function<Vec3<double>(std::size_t k, const Vec3<double>& position, double time)>;

  /// The particles must be in the order of memory, larger ones first. Of the contacts, which must have i > j,
  /// only the histories are used. Without a push particles may sleep (LoadMark::sleeps), as in the engine.
  Driven(const Model& model, const Packing& start, Push push) : model_(model), push_(std::move(push)) {
    state_.cell = start.cell;
    for (std::size_t k = 0; k < start.size(); ++k) {
      Particle<double, Law::spins> p{};
      p.position = start.fraction[k];
      p.velocity = start.velocity[k];
      p.radius = start.radius[k];
      p.inverse_mass = 1 / start.mass[k];
      if constexpr (Law::spins) {
        p.spin = start.spin[k];
        p.inverse_inertia = 1 / sphere_inertia(start.mass[k], start.radius[k]);
      }
      state_.particles.push_back(p);
    }
    const double everything = 0.2 * start.cell.edges.xx;
    state_.pairs = listed(start, {everything, 0});
    require(state_.pairs.rows() == start.size() * (start.size() - 1) / 2 && state_.pairs.quarter.empty(),
            "every pair is listed, once");
    state_.loads.resize(start.size());
    state_.rows.assign(state_.pairs.rows(), {});
    state_.contact_state.clear(state_.pairs.rows(), start.size(), Law::spins);
    for (const Contact& c : start.contacts) {
      state_.contact_state.touch(row(c.i, c.j), c.i, c.j);
      if constexpr (Law::spins) state_.contact_state.springs[row(c.i, c.j)].history = c.history;
    }
    gather(0);
  }

  void advance(std::int64_t steps) {
    for (std::int64_t n = 0; n < steps; ++n) {
      SquaredDisplacement unused;
      kick_and_drift<S>(model_.barostat, model_.time_step, state_.cell, state_.pairs, state_.contact_state,
                        state_.loads, state_.particles, unused);
      ++state_.step;
      gather(model_.time_step);
    }
  }

  double time() const { return static_cast<double>(state_.step) * model_.time_step; }
  const State<S>& state() const { return state_; }
  const Particle<double, Law::spins>& particle(std::size_t k) const { return state_.particles[k]; }
  Vec3<double> position(std::size_t k) const {
    return state_.cell.edges * in_unit_cell(state_.particles[k].position);
  }

  /// Row of particle i and the earlier particle j.
  std::size_t row(std::size_t i, std::size_t j) const { return state_.pairs.first[i] + j; }
  Vec3<double> force(std::size_t i, std::size_t j) const { return state_.rows[row(i, j)].force; }
  Vec3<double> history(std::size_t i, std::size_t j) const {
    return state_.contact_state.springs[row(i, j)].history;
  }

 private:
  /// Computes the forces at the end of a step, and the second half kick: first the engine's, with the forces
  /// of the contacts, then the one with the external forces.
  void gather(double time_step) {
    contact_forces<S>(model_, time_step, state_.cell, state_.pairs, state_.particles, state_.loads,
                      state_.rows, state_.contact_state, every_row_, state_.stress.contacts, work_);
    gather_and_kick<S>(model_.barostat, time_step, state_.cell, state_.pairs, state_.rows,
                       state_.contact_state, state_.loads, state_.particles, state_.stress.motion);
    for (std::size_t k = 0; push_ && k < state_.particles.size(); ++k) {
      const Vec3<double> force = push_(k, position(k), time());
      state_.loads[k].force += force;
      state_.contact_state.loaded[k] = has_load;
      auto& p = state_.particles[k];
      p.velocity += (0.5 * time_step * p.inverse_mass) * force;
    }
  }

  Model model_;
  Push push_;
  State<S> state_;
  InnerList every_row_;
  ContactWork work_;
};

}  // namespace furnas
