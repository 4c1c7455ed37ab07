// Jams 1000 equal spheres with friction and says how dense they are; docs/library.md builds it.
#include <engine/protocol/run.h>
#include <engine/start/mixture.h>

#include <iostream>

int main() {
  const furnas::Packing gas = furnas::dilute_start({.size_ratio = 1, .large = 1000, .seed = 1});
  furnas::Protocol protocol;  // the study's pressure, damping and step
  protocol.contact.friction = 0.3;
  const furnas::Jam jam = furnas::jam(gas, protocol);
  std::cout << "verdict " << to_string(jam.verdict) << '\n';
  if (jam.phi_J())
    std::cout << "phi_J " << *jam.phi_J() << ", " << jam.measures.contacts << " contacts\n";
  else
    std::cout << "phi " << jam.measures.phi << ", no phi_J: " << jam.rest.waiting_for << jam.fault << '\n';
}
