#include "engine/events/monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "engine/monitor/audit.h"
#include "engine/monitor/faults.h"

namespace furnas {
namespace {

constexpr std::size_t audited_particles = 32;

std::string energy_fault(const Measures& m) {
  const double gap = m.ledger.relative_gap(m.energy.total());
  if (std::abs(gap) < largest_energy_gap) return {};
  return "the balance of the energy misses " + std::to_string(gap) + " of what went through at step " +
         std::to_string(m.step) + ", allowed " + std::to_string(largest_energy_gap) +
         "; take a shorter time step";
}

}  // namespace

Monitor::Momentum Monitor::momentum_of(Observation& now) {
  const Packing& p = now.packing();
  Momentum m{{}, 0, p.cell.edges, now.step(), now.replaced()};
  double squares = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vec3<double> momentum = p.mass[k] * p.velocity[k];
    m.sum += momentum;
    squares += dot(momentum, momentum);
  }
  m.spread = std::sqrt(squares);
  return m;
}

/// Contacts conserve the momentum. The strain of the cell changes the momentum in proportion to it, and
/// rounding changes it a little. A step rounds each velocity about ten times. The rounding errors of one
/// particle may have the same sign in many steps, so errors are taken to grow in proportion to the number of
/// steps. The errors of different particles are independent, so they add up like random numbers.
std::string Monitor::momentum_fault(Observation& now) {
  constexpr double roundings = 32;  // of a velocity or a force sum in a step, with a safety margin
  const Momentum here = momentum_of(now);
  std::string fault;
  if (last_ && last_->replaced == here.replaced) {
    const Measures& m = now.measures();
    const Model& model = now.simulation().model();
    const auto steps = static_cast<double>(here.step - last_->step);
    const double impulse = m.mean_force * static_cast<double>(m.contacts) * model.time_step;
    const double unit = (model.precision == Precision::mixed ? std::numeric_limits<float>::epsilon()
                                                             : std::numeric_limits<double>::epsilon()) /
                        2;
    const double strain = strain_between(last_->edges, here.edges);
    const double allowed = roundings * unit * steps * (std::max(here.spread, last_->spread) + impulse) +
                           4 * strain * norm(last_->sum);
    const double change = norm(here.sum - last_->sum);
    if (change > allowed)
      fault = "the momentum of all particles has changed by " + std::to_string(change / allowed) +
              " times what rounding may do at step " + std::to_string(here.step) +
              "; this is an error of the program";
  }
  last_ = here;
  return fault;
}

std::string Monitor::saved() {
  if (!last_) return {};
  const auto& [sum, spread, h, step, replaced] = *last_;
  return exact_text(sum.x, sum.y, sum.z, spread, h.xx, h.yy, h.zz, h.yz, h.xz, h.xy, step, replaced);
}

void Monitor::restore(const std::string& saved) {
  last_.reset();
  if (saved.empty()) return;
  Momentum m;
  auto& [sum, spread, h, step, replaced] = m;
  if (!Numbers(saved).take_all(sum.x, sum.y, sum.z, spread, h.xx, h.yy, h.zz, h.yz, h.xz, h.xy, step,
                               replaced))
    throw InputError("the monitor remembers \"" + saved + "\", which is no momentum");
  last_ = m;
}

bool Monitor::due(Observation& now) {
  sentence_ = fault_of(now.packing(), now.simulation().model());
  if (sentence_.empty()) sentence_ = energy_fault(now.measures());
  if (sentence_.empty()) sentence_ = momentum_fault(now);
  if (sentence_.empty())
    sentence_ = audit_contacts(now.packing(), audited_particles, static_cast<std::uint64_t>(now.step()));
  return !sentence_.empty();
}

}  // namespace furnas
