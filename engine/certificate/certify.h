#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/certificate/contact_network.h"
#include "engine/certificate/kick.h"
#include "engine/certificate/part.h"
#include "engine/certificate/small_motion.h"
#include "engine/state/cell.h"
#include "engine/state/packing.h"

namespace furnas {

/// The contact law and the bath of a packing, and the tolerances of the certificate.
struct CertificateTerms {
  Springs springs;
  CellMotion cell;  ///< freedom, pressure p_a and equation of motion of the cell

  double tight_imbalance = 1e-4;   ///< mean |net force|/mean |F|: "tight" up to this value
  double imbalance = 1e-3;         ///< the same: accepted up to this value
  double single_imbalance = 5e-2;  ///< |net force|/load of any one particle (statics.h)
  double stress_error = 1e-3;      ///< |P - p_a|/p_a of each component that can strain the cell
  double cone_excess = 1e-2;       ///< (|F_t| - mu F_n)/(mu mean F_n) of any one contact
  int eigenvalues = 6;             ///< number of the lowest eigenvalues to report
};

/// Quality of the force balance.
enum class Balance { off, loose, tight };

/// The word for it in reports.
const char* to_string(Balance balance);

/// The results of all parts of the certificate of a packing.
struct Certificate {
  std::int64_t particles{};
  std::int64_t backbone{};       ///< its particles, if every overlap counts as a contact
  std::int64_t live_backbone{};  ///< the same, counting only contacts above 1 % of the mean F_n of their kind
  std::int64_t contacts{};       ///< among the backbone
  int least_contacts{};          ///< z_min: particles with fewer contacts do not belong to the backbone
  std::int64_t unlisted{};       ///< overlapping pairs that are missing in the packing's list of contacts
  std::int64_t open{};           ///< contacts of the list whose spheres do not overlap
  Balance balance{};             ///< of forces and torques on the backbone
  double bulk_modulus{};         ///< K; NaN if it could not be computed [k_n/d_s]
  double shear_modulus{};        ///< G, mean over directions [k_n/d_s]
  std::vector<double> eigenvalues;  ///< the lowest [k_n]
  double growth_rate{};             ///< of the fastest growing motion; 0 if none was found [1/time]
  Kick kick;                        ///< the motions that cost no energy or grow
  std::vector<Part> parts;

  bool passed() const {
    return std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.passed(); });
  }
};

/// Tests whether a packing is jammed, from its positions, radii, masses, cell and tangential histories. The
/// test reads no force, velocity or sum of the run, and shares no code with the run's search and step. From
/// the law it takes the spring force, stiffness and damping of a contact (docs/theory/certificate.md). Throws
/// InputError for a packing that is not valid (engine/state/validate.h).
Certificate certify(const Packing& packing, const CertificateTerms& terms);

}  // namespace furnas
