#include "engine/simulation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/monitor/energy.h"
#include "engine/phases/forces.h"
#include "engine/phases/integrate.h"
#include "engine/search/carry_over.h"
#include "engine/search/find_pairs.h"
#include "engine/search/inner_skin.h"
#include "engine/search/size_classes.h"
#include "engine/state/validate.h"
#include "engine/step.h"

namespace furnas {
namespace {

template <class Real>
Vec3<double> wide(const Vec3<Real>& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

template <class Numerics>
class SimulationOf final : public Simulation {
 public:
  using Real = typename Numerics::Real;
  static constexpr bool spins = Numerics::spins;

  SimulationOf(const Model& model, const Packing& packing, int threads, Execution execution)
      : model_(model),
        workers_(threads),
        as_graph_(execution == Execution::as_graph || (execution == Execution::automatic && threads > 1)),
        step_(make_step<Numerics>(model_, count_, state_, work_)) {
    load(packing);
  }

  void advance(std::int64_t steps, const std::atomic<bool>* stop) override {
    workers_.run([&] {
      for (std::int64_t n = 0; n < steps && !(stop && *stop); ++n) {
        as_graph_ ? step_.run_as_graph() : step_.run_in_order();
        ++state_.step;
      }
    });
  }

  Packing packing() const override;
  void load(const Packing& packing) override;

  std::int64_t step() const override { return state_.step; }
  const Cell& cell() const override { return state_.cell; }
  const Model& model() const override { return model_; }
  void set_motion(std::span<const Vec3<double>> velocity, std::span<const Vec3<double>> spin,
                  const Triangle& rate) override;
  void set_bath(const Barostat& bath) override {
    require(bath.freedom == model_.barostat.freedom, "the phases of a step are chosen by the cell's freedom");
    model_.barostat = bath;
  }
  int threads() const override { return workers_.threads(); }
  NeighbourCounts neighbours() const override {
    return {.builds = state_.pairs.builds,
            .pairs = state_.pairs.rows(),
            .inner_pairs = inner_rows(state_.pairs, work_.inner)};
  }
  const StepGraph& graph() const override { return step_; }

 private:
  /// The time at an earlier step; all later steps have the same length.
  struct Clock {
    std::int64_t step{};
    double time{};  ///< [time]
    double at(std::int64_t later, double time_step) const {
      return time + static_cast<double>(later - step) * time_step;
    }
  };

  static Vec3<Real> narrow(const Vec3<double>& v) { return {Real(v.x), Real(v.y), Real(v.z)}; }
  void take_particles(const Packing& packing);
  void build_list(std::int64_t builds);
  void list_nothing(std::int64_t builds);
  void restore_contacts(const Packing& packing);
  void take_forces();
  std::vector<Contact> contacts() const;

  Model model_;
  Workers workers_;
  bool as_graph_;
  std::size_t count_{};
  Labels labels_;  ///< of the loaded packing, copied into the packing that packing() returns
  Clock clock_;
  State<Numerics> state_;
  StepWork<Real> work_;
  StepGraph step_;
};

template <class Numerics>
void SimulationOf<Numerics>::load(const Packing& p) {
  validate(p);
  workers_.run([&] {
    const std::int64_t builds = state_.pairs.builds;
    take_particles(p);
    try {
      build_list(builds);
    } catch (
        const NumericalFailure&) {  // the cell has collapsed: what is left can still be measured and saved
      list_nothing(builds);
      throw;
    }
    p.order.empty() ? take_forces() : restore_contacts(p);
  });
}

template <class Numerics>
void SimulationOf<Numerics>::take_particles(const Packing& p) {
  count_ = p.size();
  state_ = {};
  state_.step = p.step;
  clock_ = {};
  if (p.time != clock_.at(p.step, model_.time_step)) clock_ = {p.step, p.time};
  state_.cell = p.cell;
  state_.cell.rate = possible(p.cell.rate, model_.barostat.freedom);
  state_.stress = p.stress;
  state_.ledger = p.ledger;
  labels_ = p.labels;
  state_.id = p.order.empty() ? memory_order(p) : p.order;
  state_.particles.reserve(count_);
  state_.loads.reserve(count_);
  state_.mass.reserve(count_);
  state_.species.reserve(count_);
  state_.image.reserve(count_);
  for (std::uint32_t k : state_.id) {
    Particle<Real, spins> particle{};
    particle.position = p.fraction[k];
    particle.velocity = narrow(p.velocity[k]);
    particle.radius = Real(p.radius[k]);
    particle.inverse_mass = Real(1 / p.mass[k]);
    Load<Real, spins> load{};
    load.force = narrow(p.force[k]);
    if constexpr (spins) {
      particle.spin = narrow(p.spin[k]);
      // Uses the rounded radius, because a resumed run knows no other.
      particle.inverse_inertia = Real(1 / sphere_inertia(p.mass[k], particle.radius));
      load.torque = narrow(p.torque[k]);
    }
    state_.particles.push_back(particle);
    state_.loads.push_back(load);
    state_.mass.push_back(p.mass[k]);
    state_.species.push_back(p.species[k]);
    state_.image.push_back(p.image[k]);
  }
}

template <class Numerics>
void SimulationOf<Numerics>::build_list(std::int64_t builds) {
  {
    std::vector<double> radii(count_);
    for (std::size_t n = 0; n < count_; ++n) radii[n] = state_.particles[n].radius;
    state_.pairs.classes = size_classes(radii);
  }
  work_.displacement.largest.assign(state_.pairs.classes.size(), 0);
  ListDraft<Real> draft;
  bin_particles<Numerics>(model_.skin, state_.step, state_.cell, work_.displacement, state_.particles,
                          state_.pairs, state_.image, draft);
  search_pairs(state_.step, state_.cell, draft, state_.pairs);
  put_down_contacts<Numerics>(state_.pairs, draft, state_.rows, state_.contact_state, work_.displacement);
  state_.pairs.builds = builds + 1;
  work_.inner = {};
}

/// Makes a list without pairs.
template <class Numerics>
void SimulationOf<Numerics>::list_nothing(std::int64_t builds) {
  state_.pairs = {};
  state_.pairs.builds = builds;
  work_.inner = {};
  state_.pairs.first.assign(count_ + 1, 0);
  for (const auto& particle : state_.particles) state_.pairs.reference.push_back(particle.position);
  state_.rows.clear();
  state_.contact_state.clear(0, 0, spins);
}

template <class Numerics>
void SimulationOf<Numerics>::take_forces() {
  const double no_step = 0;
  contact_forces<Numerics>(model_, no_step, state_.cell, state_.pairs, state_.particles, state_.loads,
                           state_.rows, state_.contact_state, work_.inner, state_.stress.contacts,
                           work_.work);
  gather_and_kick<Numerics>(model_.barostat, no_step, state_.cell, state_.pairs, state_.rows,
                            state_.contact_state, state_.loads, state_.particles, state_.stress.motion);
  state_.ledger = {};
  state_.ledger.initial = energy(packing(), model_.law).total();
}

template <class Numerics>
void SimulationOf<Numerics>::restore_contacts(const Packing& p) {
  std::vector<std::uint32_t> place(count_);
  for (std::uint32_t n = 0; n < count_; ++n) place[state_.id[n]] = n;
  const PairList& list = state_.pairs;
  for (const Contact& c : p.contacts) {
    std::uint32_t i = place[c.i];
    std::uint32_t j = place[c.j];
    auto image = c.image;
    double sign = 1;
    // A particle that touches its own image does so on two opposite sides. The list holds only the image
    // below zero.
    if (i < j || (i == j && decltype(image){} < image)) {
      image = image_seen_from_j(image, p.fraction[c.i], p.fraction[c.j]);
      std::swap(i, j);
      sign = -1;
    }
    std::uint64_t k = list.first[i];
    while (k < list.first[i + 1] &&
           !(list.partner[k] == j &&
             image_of_row(list, k, state_.particles[i].position, state_.particles[j].position) == image))
      ++k;
    if (k == list.first[i + 1])
      throw InputError("particles " + std::to_string(p.id(c.i)) + " and " + std::to_string(p.id(c.j)) +
                       " have a contact and are not neighbours");
    state_.rows[k].force = {Real(sign * c.force.x), Real(sign * c.force.y), Real(sign * c.force.z)};
    state_.contact_state.touch(k, i, j);
    if constexpr (spins)
      state_.contact_state.springs[k].history = {Real(sign * c.history.x), Real(sign * c.history.y),
                                                 Real(sign * c.history.z)};
  }
}

template <class Numerics>
void SimulationOf<Numerics>::set_motion(std::span<const Vec3<double>> velocity,
                                        std::span<const Vec3<double>> spin, const Triangle& rate) {
  require(velocity.size() == count_ && spin.size() == count_, "a velocity and a spin for each particle");
  state_.contact_state.wake_all();
  std::vector<std::uint32_t> place(count_);
  for (std::uint32_t n = 0; n < count_; ++n) place[state_.id[n]] = n;
  const auto kinetic = [&](std::uint32_t n) {
    const auto& particle = state_.particles[n];
    Vec3<double> turning{};
    if constexpr (spins) turning = wide(particle.spin);
    return kinetic_energy(state_.mass[n], particle.radius, wide(particle.velocity), turning);
  };
  for (std::size_t k = 0; k < count_; ++k) {
    auto& particle = state_.particles[place[k]];
    state_.ledger.quenched += kinetic(place[k]);
    particle.velocity = narrow(velocity[k]);
    if constexpr (spins) particle.spin = narrow(spin[k]);
    state_.ledger.quenched -= kinetic(place[k]);
  }
  state_.cell.rate = possible(rate, model_.barostat.freedom);
}

template <class Numerics>
std::vector<Contact> SimulationOf<Numerics>::contacts() const {
  const PairList& list = state_.pairs;
  std::vector<Contact> contacts;
  const auto& touching = state_.contact_state.touching;
  const auto touch = static_cast<std::size_t>(std::count(touching.begin(), touching.end(), 1));
  // Because of rounding, a few more pairs may overlap here than in the step; the vector reserves room for
  // them to avoid a copy. A pair that overlaps by more than rounding but is not marked as touching was missed
  // by the step. Such a pair is left out, so that the audit of the contacts reports it as missing.
  constexpr double rounding = 1e-9;  // [d_s]
  contacts.reserve(touch + touch / 256 + 16);
  for (std::uint32_t i = 0; i < count_; ++i) {
    const auto& p = state_.particles[i];
    for (std::uint64_t k = list.first[i]; k < list.first[i + 1]; ++k) {
      const std::uint32_t j = list.partner[k];
      const auto& q = state_.particles[j];
      const Vec3<double> branch =
          state_.cell.edges * (list.quarter.empty()
                                   ? nearest_difference(p.position, q.position)
                                   : row_difference(p.position, q.position, list.quarter[k]));
      const double reach = double(p.radius) + double(q.radius);
      const double square = dot(branch, branch);
      if (square >= reach * reach) continue;
      const double overlap = reach - std::sqrt(square);
      if (touching[k] == 0 && overlap > rounding) continue;
      Contact c;
      c.i = state_.id[i];
      c.j = state_.id[j];
      c.image = image_of_row(list, k, p.position, q.position);
      c.branch = branch;
      c.overlap = overlap;
      c.force = wide(state_.rows[k].force);
      if constexpr (spins) {
        c.history = wide(state_.contact_state.springs[k].history);
        const double normal = std::abs(dot(c.force, branch)) / std::sqrt(square);
        const double tangential = std::sqrt(std::max(dot(c.force, c.force) - normal * normal, 0.0));
        c.sliding = at_coulomb_limit(tangential, normal, constants_of(model_.law).friction);
      }
      contacts.push_back(c);
    }
  }
  return contacts;
}

template <class Numerics>
Packing SimulationOf<Numerics>::packing() const {
  work_.draft = {};  // the copy needs the memory more
  Packing p;
  p.step = state_.step;
  p.time = clock_.at(state_.step, model_.time_step);
  p.cell = state_.cell;
  p.stress = state_.stress;
  p.ledger = state_.ledger;
  p.order = state_.id;
  p.labels = labels_;
  p.resize(count_);
  for (std::size_t n = 0; n < count_; ++n) {
    const std::uint32_t k = state_.id[n];
    const auto& particle = state_.particles[n];
    p.species[k] = state_.species[n];
    p.radius[k] = particle.radius;
    p.mass[k] = state_.mass[n];
    p.fraction[k] = particle.position;
    p.image[k] = crossed(state_.image[n], state_.pairs.reference[n], particle.position);
    p.velocity[k] = wide(particle.velocity);
    p.force[k] = wide(state_.loads[n].force);
    if constexpr (spins) {
      p.spin[k] = wide(particle.spin);
      p.torque[k] = wide(state_.loads[n].torque);
    }
  }
  p.contacts = contacts();
  return p;
}

}  // namespace

std::unique_ptr<Simulation> make_simulation(const Model& model, const Packing& packing, int threads,
                                            Execution execution) try {
  return std::visit(
      [&](const auto& law) -> std::unique_ptr<Simulation> {
        using Law = std::decay_t<decltype(law)>;
        if (model.precision == Precision::mixed)
          return std::make_unique<SimulationOf<Numerics<Law, float>>>(model, packing, threads, execution);
        return std::make_unique<SimulationOf<Numerics<Law, double>>>(model, packing, threads, execution);
      },
      model.law);
} catch (const NumericalFailure& error) {
  throw InputError(std::string("the packing cannot be simulated: ") + error.what());
}

int threads_for(std::size_t particles) {
  constexpr std::size_t particles_a_thread = 2000;
  const auto most = static_cast<std::size_t>(available_threads());
  return static_cast<int>(std::clamp<std::size_t>(particles / particles_a_thread, 1, most));
}

}  // namespace furnas
