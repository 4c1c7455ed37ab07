// Jams 1000 equal spheres with friction and says how dense they are; docs/reference/library.md tells how to
// build it.

#include <iostream>

#include "engine/protocol/run.h"
#include "engine/start/mixture.h"

int main() {
  const furnas::Packing gas = furnas::dilute_start({.size_ratio = 1, .large = 1000, .seed = 1});
  furnas::Protocol protocol;  // pressure and contact damping of the paper
  protocol.contact.friction = 0.3;
  const furnas::Jam jam = furnas::jam(gas, protocol);
  std::cout << "verdict " << to_string(jam.verdict) << '\n';
  if (jam.phi_J())
    std::cout << "phi_J " << *jam.phi_J() << '\n';
  else
    std::cout << "phi " << jam.measures.phi << ", no phi_J: " << jam.rest.waiting_for << jam.fault << '\n';
}
