#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/sphere.h"
#include "engine/base/vec3.h"
#include "engine/state/cell.h"
#include "engine/state/fraction.h"
#include "engine/state/ledger.h"
#include "engine/state/stress.h"

namespace furnas {

/// The species of a particle. In a mixture or a file with one species only, all particles are `large`.
enum class Species : std::uint8_t { large = 0, small = 1 };

/// Largest number of particles of a packing: the neighbour search numbers its bins, up to two per particle,
/// with 32 bits.
inline constexpr std::int64_t most_particles = 2'147'483'647;

/// Share of Coulomb's limit by which a force that was cut to the limit may lie below it, because of rounding
/// to single precision.
inline constexpr double coulomb_tolerance = 1e-6;

/// Whether a tangential force has reached Coulomb's limit, within a share `tolerance` of the limit.
inline bool at_coulomb_limit(double tangential, double normal, double friction,
                             double tolerance = coulomb_tolerance) {
  return tangential >= (1 - tolerance) * friction * normal;
}

/// A contact of two particles at the end of a step.
struct Contact {
  std::uint32_t i{}, j{};              ///< indices into the packing's arrays
  std::array<std::int8_t, 3> image{};  ///< cells between the nearest image and the one that is touched
  bool sliding{};                      ///< the tangential force has reached friction times the normal force
  Vec3<double> branch;                 ///< centre of j (its image that is touched) to centre of i [d_s]
  double overlap{};                    ///< R_i + R_j - |branch| > 0 [d_s]
  Vec3<double> force;                  ///< on i [k_n d_s]
  Vec3<double> history;  ///< tangential displacement xi of i against j [d_s]; zero without friction
};

/// Names and numbers from the file from which a packing was read. Runs and conversions keep them, but for
/// `turned`; the engine does not use them.
struct Labels {
  std::vector<std::int64_t> id;    ///< of each particle, rising; empty: 1, 2, 3, ...
  std::vector<std::int32_t> type;  ///< of each particle, 1 or more; empty: 1 is large, 2 is small
  std::vector<std::string> names;  ///< of the types 1, 2, ...; empty: they have none of their own
  Vec3<double> origin;             ///< corner of the cell in the coordinates of the file [d_s]
  bool turned = false;             ///< cell and vectors were rotated when the file was read
  friend bool operator==(const Labels&, const Labels&) = default;
};

/// A packing in the form that the program uses outside the step: in double precision, in order of id.
struct Packing {
  std::int64_t step{};  ///< steps since the start
  double time{};        ///< [time unit sqrt(m/k_n), m = rho d_s^3]
  Cell cell;
  std::vector<Species> species;
  std::vector<double> radius;          ///< [d_s]
  std::vector<double> mass;            ///< [rho d_s^3]
  std::vector<Fraction> fraction;      ///< position in the cell
  std::vector<Image> image;            ///< number of cells crossed since the start
  std::vector<Vec3<double>> velocity;  ///< peculiar, without the cell's affine flow [d_s/time]
  std::vector<Vec3<double>> spin;      ///< angular velocity [1/time]; zero without friction
  std::vector<Vec3<double>> force;     ///< sum over contacts [k_n d_s]
  std::vector<Vec3<double>> torque;    ///< sum over contacts [k_n d_s^2]
  std::vector<Contact> contacts;       ///< all of them, live or not
  Stress stress;                       ///< of this instant, as the barostat uses it
  Ledger ledger;                       ///< where the energy came from and went
  std::vector<std::uint32_t> order;    ///< index of the n-th particle in memory; empty: the engine chooses
  Labels labels;                       ///< names and numbers from files

  std::size_t size() const { return radius.size(); }

  /// The id of particle k in files.
  std::int64_t id(std::size_t k) const {
    return labels.id.empty() ? static_cast<std::int64_t>(k) + 1 : labels.id[k];
  }

  /// Sets the number of particles; new ones are at rest at the origin with no size.
  void resize(std::size_t n) {
    species.resize(n);
    radius.resize(n);
    mass.resize(n);
    fraction.resize(n);
    image.resize(n);
    velocity.resize(n);
    spin.resize(n);
    force.resize(n);
    torque.resize(n);
  }

  /// Centre of particle k in the cell, each fraction in [0, 1] [d_s].
  Vec3<double> position(std::size_t k) const { return cell.edges * in_unit_cell(fraction[k]); }

  /// Centre of particle k with the cells it has crossed [d_s].
  Vec3<double> unwrapped(std::size_t k) const {
    const Vec3<double> s = in_unit_cell(fraction[k]);
    return cell.edges * Vec3<double>{s.x + image[k][0], s.y + image[k][1], s.z + image[k][2]};
  }

  /// Volume of the spheres [d_s^3].
  double sphere_volume() const {
    double sum = 0;
    for (double r : radius) sum += r * r * r;
    return sum * furnas::sphere_volume(1);
  }

  /// Packing fraction phi.
  double fraction_filled() const { return sphere_volume() / cell.volume(); }
};

}  // namespace furnas
