#pragma once

#include "engine/simulation.h"
#include "engine/start/mixture.h"

namespace furnas::test {

/// A gas that is squeezed hard enough to touch, slide, bounce and shear within a few hundred steps:
/// about `large` x 64 particles in two sizes.
inline Packing hasty_gas(std::int64_t large = 20, double size_ratio = 3) {
  return dilute_start(
      {.size_ratio = size_ratio, .small_fraction = 0.7, .large = large, .start_fraction = 0.3, .seed = 5});
}

/// The model that squeezes it; without friction the law that has no spin.
inline Model hasty_model(double friction, bool legacy = false) {
  HookeConstants constants;
  constants.friction = friction;
  Model model;
  if (friction > 0 && legacy)
    model.law = HookeHistory{constants};
  else if (friction > 0)
    model.law = HookeSynchronized{constants};
  else
    model.law = Frictionless<false>{constants};
  model.barostat.pressure = 1e-2;
  model.barostat.inertia = 3000;
  return model;
}

}  // namespace furnas::test
