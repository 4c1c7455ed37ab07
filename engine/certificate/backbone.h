#pragma once

#include <cstdint>
#include <vector>

#include "engine/certificate/contact_network.h"
#include "engine/state/packing.h"

namespace furnas {

/// What counts as carrying.
struct CoreRule {
  double force_share = 0.01;    ///< a contact counts above this share of the mean F_n of its kind
  int least_contacts = 4;       ///< z_min: particles with fewer such contacts are taken out, again and again
  bool by_constraints = false;  ///< a contact that slides counts for 2/3 of one
};

/// The particles that carry the packing, and the contacts among them.
struct Backbone {
  std::vector<bool> contains;               ///< for each particle
  std::vector<std::uint32_t> particles;     ///< in order
  std::vector<const StaticContact*> bonds;  ///< all contacts among them, however weak
  std::int64_t rule_breaks{};  ///< members with fewer than z_min counting contacts among themselves, rattlers
                               ///< with as many to members: 0, or the core is wrong
};

/// The k-core of the contacts that count: the certificate's own, by rounds over all contacts.
Backbone find_backbone(const ContactNetwork& network, const std::vector<Species>& species,
                       const CoreRule& rule);

/// How the bonds of a backbone hang together across the faces of the cell.
struct Percolation {
  std::int64_t pieces{};         ///< connected pieces of the backbone
  std::int64_t largest_piece{};  ///< particles in the largest one
  int directions{};              ///< independent lattice vectors along which it meets its own image, 0 to 3
};

Percolation percolation(const Backbone& backbone);

}  // namespace furnas
