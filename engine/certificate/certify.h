#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/certificate/contact_network.h"
#include "engine/certificate/part.h"
#include "engine/certificate/small_motion.h"
#include "engine/state/cell.h"
#include "engine/state/packing.h"

namespace furnas {

/// What a packing claims to be, and how closely it must be that.
struct CertificateTerms {
  Springs springs;
  CellMotion cell;  ///< its freedom and p_a, and how it moves

  double tight_imbalance = 1e-4;   ///< mean |net force|/mean |F| that is called tight
  double imbalance = 1e-3;         ///< the same, that is accepted
  double single_imbalance = 5e-2;  ///< |net force|/load of any one particle (statics.h)
  double stress_error = 1e-3;      ///< |P - p_a| of each component the cell answers to, over p_a
  double cone_excess = 1e-2;       ///< (|F_t| - mu F_n)/(mu mean F_n) of any one contact
  int eigenvalues = 6;             ///< shown
  bool histories = true;           ///< the packing has the tangential displacements of its contacts
};

/// How closely forces balance.
enum class Balance { off, loose, tight };

const char* to_string(Balance balance);

/// The answers of all parts about a packing.
struct Certificate {
  std::int64_t particles{};
  std::int64_t backbone{};       ///< particles of it, every overlap counted
  std::int64_t live_backbone{};  ///< by the rule of a run: contacts above 1 % of the mean F_n of their kind
  std::int64_t contacts{};       ///< among the backbone
  int least_contacts{};          ///< with fewer contacts a particle is no part of the backbone
  std::int64_t unlisted{};       ///< contacts of the geometry that the packing's list does not have
  std::int64_t open{};           ///< contacts of the list whose spheres do not overlap
  Balance balance{};             ///< of forces and torques on the backbone
  double bulk_modulus{};         ///< K, not a number if it could not be had [k_n/d_s]
  double shear_modulus{};        ///< G, mean over directions [k_n/d_s]
  std::vector<double> eigenvalues;  ///< the lowest [k_n]
  double growth_rate{};             ///< of the fastest motion that grows, 0 if none was found [1/time]
  std::vector<Part> parts;

  bool passed() const {
    return std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.passed(); });
  }
};

/// Asks whether a packing is jammed, from its positions, radii, cell and tangential histories alone; reads no
/// force, velocity or sum of the run and shares no code with its search, laws or step
/// (docs/theory/certificate.md).
Certificate certify(const Packing& packing, const CertificateTerms& terms);

}  // namespace furnas
