#include "engine/events/limits.h"

namespace furnas {

std::optional<Verdict> Budget::fire(Observation& now) {
  if (now.step() < last_step_) return {};
  return Verdict::budget;
}

}  // namespace furnas
