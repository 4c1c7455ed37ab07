#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/laws/any_law.h"
#include "engine/state/packing.h"

namespace furnas {

/// The springs of contacts at rest. The spring force, stiffness and damping of a contact are those of the
/// law; the overlaps and the friction at the limit are computed here.
struct Springs {
  AnyLaw law = Frictionless<false>{};
  double at_limit = 1e-3;  ///< a contact slides when |F_t| reaches (1 - at_limit) mu F_n

  /// Coulomb coefficient mu; 0: no tangential springs, no rotations.
  double friction() const { return has_friction(law) ? constants_of(law).friction : 0; }
};

/// A contact at rest: its geometry, and its forces without any motion.
struct StaticContact {
  std::uint32_t i{}, j{};
  std::array<std::int64_t, 3> cells{};  ///< as in Overlap
  Vec3<double> branch;                  ///< centre of j (its image) to centre of i [d_s]
  Vec3<double> normal;                  ///< branch/|branch|
  double distance{};                    ///< |branch| [d_s]
  double arm_i{}, arm_j{};              ///< from the centres to the contact point [d_s]
  double normal_force{};                ///< F_n of the spring, > 0 [k_n d_s]
  double normal_stiffness{};            ///< dF_n/d overlap [k_n]
  double tangential_stiffness{};        ///< k_t [k_n]
  double normal_damping{};              ///< m_eff gamma_n [k_n time]
  double tangential_damping{};          ///< m_eff gamma_t [k_n time]
  Vec3<double> tangential_force;        ///< F_t = -k_t xi, on i [k_n d_s]
  bool sliding{};                       ///< at the Coulomb limit
  bool known{};                         ///< the contact is in the packing's list, with its history

  Vec3<double> force() const { return normal_force * normal + tangential_force; }  ///< on i [k_n d_s]
};

/// The contacts of a packing, computed from its positions, radii, cell and histories. Nothing else of the
/// packing is read: no force, no branch, no velocity, no sum of the run.
struct ContactNetwork {
  Springs springs;
  std::vector<double> radius;  ///< of each particle [d_s]
  std::vector<double> mass;    ///< of each particle [rho d_s^3]
  double volume{};             ///< of the cell [d_s^3]
  std::vector<StaticContact> contacts;
  double mean_force{};         ///< mean |F| of all contacts; 0 without any [k_n d_s]
  double mean_normal_force{};  ///< [k_n d_s]
  std::int64_t unlisted{};     ///< contacts that are missing in the packing's list
  std::int64_t open{};         ///< contacts of the packing's list whose spheres do not overlap

  bool frictional() const { return springs.friction() > 0; }
};

/// Finds the contacts and evaluates their forces at rest.
ContactNetwork contact_network(const Packing& packing, const Springs& springs);

}  // namespace furnas
