#include "engine/protocol/schedule.h"

#include <iterator>
#include <memory>
#include <utility>

#include "engine/events/flip.h"
#include "engine/events/limits.h"
#include "engine/events/minimize.h"
#include "engine/events/monitor.h"
#include "engine/events/quench.h"
#include "engine/events/renew_order.h"
#include "engine/events/settle.h"

namespace furnas {

Events schedule(const Protocol& protocol, const Rhythm& rhythm, std::vector<Barostat> later, RestWatch& watch,
                std::vector<RestingState>& reached, Onlookers onlookers) {
  constexpr double order_time = 200, flip_time = 2, quench_time = 2;  // [t_c]
  const bool can_rest = protocol.cell != CellFreedom::fixed;
  const bool quenches = can_rest && !protocol.rest.kinetic_energy_alone;
  const bool minimizes = quenches && protocol.minimizer && protocol.contact.friction == 0;

  Events events;
  const auto add = [&](std::unique_ptr<Event> event) { events.push_back(std::move(event)); };
  const auto add_all = [&](Events& some) { std::move(some.begin(), some.end(), std::back_inserter(events)); };

  add(std::make_unique<Monitor>());
  add(std::make_unique<Flip>(rhythm.steps(flip_time)));
  add(std::make_unique<RenewOrder>(rhythm.steps(order_time)));
  add_all(onlookers.before_verdict);
  auto next_pressure = std::make_unique<NextPressure>(watch, std::move(later), reached);
  NextPressure& next = *next_pressure;
  if (can_rest) add(std::move(next_pressure));
  if (can_rest) add(std::make_unique<AtRest>(watch, rhythm.steps(quench_time)));
  if (minimizes) add(std::make_unique<Minimize>(watch, 0, &next));
  if (quenches) {
    auto quench = std::make_unique<Quench>(watch);
    auto settle = std::make_unique<Settle>(watch, next, *quench, rhythm.steps(drift_time));
    add(std::move(quench));
    add(std::move(settle));
  }
  add_all(onlookers.after_verdict);
  add(std::make_unique<Budget>(protocol.steps));
  add_all(onlookers.limits);
  return events;
}

}  // namespace furnas
