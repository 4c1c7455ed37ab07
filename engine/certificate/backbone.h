#pragma once

#include <cstdint>
#include <vector>

#include "engine/certificate/contact_network.h"
#include "engine/state/packing.h"

namespace furnas {

/// The rule by which particles belong to the backbone.
struct CoreRule {
  double force_share = 0.01;    ///< a contact counts if its F_n exceeds this share of the mean of its kind
  int least_contacts = 4;       ///< z_min: particles with fewer such contacts are removed repeatedly
  bool by_constraints = false;  ///< a contact that slides counts for 2/3 of one
};

/// The particles that carry the packing, and the contacts among them.
struct Backbone {
  std::vector<bool> contains;               ///< for each particle
  std::vector<std::uint32_t> particles;     ///< in order
  std::vector<const StaticContact*> bonds;  ///< all contacts among them, however weak
  std::int64_t rule_breaks{};  ///< members with fewer than z_min counting contacts to members, plus rattlers
                               ///< with z_min or more of them. Anything but 0 means that the core is wrong
};

/// The k-core of the contacts that count. The certificate computes it by repeated passes over all contacts,
/// with code of its own.
Backbone find_backbone(const ContactNetwork& network, const std::vector<Species>& species,
                       const CoreRule& rule);

/// How the bonds of a backbone connect across the faces of the cell.
struct Percolation {
  std::int64_t pieces{};         ///< connected pieces of the backbone
  std::int64_t largest_piece{};  ///< particles in the largest one
  int directions{};  ///< independent lattice vectors along which a piece connects to its own image, 0 to 3
};

/// How the contacts of a backbone hang together.
Percolation percolation(const Backbone& backbone);

}  // namespace furnas
