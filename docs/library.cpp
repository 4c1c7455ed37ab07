// Compresses a dilute gas of 1000 equal spheres with friction 0.3 and prints its packing fraction.

#include <cstdio>

#include "engine/simulation.h"
#include "engine/start/mixture.h"

int main() {
  furnas::Mixture mixture;
  mixture.large = 1000;
  const furnas::Packing gas = furnas::dilute_start(mixture);

  furnas::Model model;
  model.law = furnas::HookeSynchronized{{.friction = 0.3}};
  model.barostat.inertia = 1000;
  const auto simulation = furnas::make_simulation(model, gas);
  simulation->advance(400);
  std::printf("phi %.4f after %ld steps\n", simulation->packing().fraction_filled(), simulation->step());
}
