#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace furnas {

/// One case: all settings of a run, as in the tables of its TOML file. The fields start from their defaults;
/// io/case_schema.cpp contains their ranges and documentation.
struct Case {
  /// The spheres of a random start.
  struct Mixture {
    double size_ratio = 1;         ///< alpha = d_l/d_s
    double small_fraction = 0;     ///< f_s, share of the small spheres in the volume of all spheres
    std::int64_t large = 1000;     ///< N_l, number of large spheres
    double start_fraction = 0.05;  ///< packing fraction of the random start
    std::int64_t seed = 1;         ///< of the random start
    std::string diameters{};       ///< path of a list of diameters, which replaces the first three keys
    friend bool operator==(const Mixture&, const Mixture&) = default;

    /// Whether size_ratio, small_fraction and large have their default values.
    bool has_default_sizes() const {
      const Mixture none;
      return size_ratio == none.size_ratio && small_fraction == none.small_fraction && large == none.large;
    }
  };

  /// A start that is read instead of drawn.
  struct Start {
    std::string file;  ///< path of a packing; empty: a random start from [mixture]
    friend bool operator==(const Start&, const Start&) = default;
  };

  /// The law between two spheres that touch.
  struct Contact {
    std::string law = "hooke_synchronized";  ///< name of the contact law
    double friction = 0.3;                   ///< Coulomb's coefficient mu
    double tangential_stiffness = 1;         ///< k_t/k_n
    double normal_damping = 0.5;             ///< gamma_n, multiplied by m_eff [1/time]
    double tangential_damping = 0.5;         ///< gamma_t, multiplied by m_eff [1/time]
    bool attraction = true;  ///< the normal force may turn negative while a contact opens (as in the paper)
    bool winding = true;  ///< damping may stretch the spring of a sliding contact beyond Coulomb's limit (as
                          ///< in the paper)
    std::string velocity = "total";  ///< relative velocity in the contact law: "peculiar" or "total"
    friend bool operator==(const Contact&, const Contact&) = default;
  };

  /// How the cell is pressed and how time advances.
  struct Compaction {
    std::vector<double> pressure = {1e-4};     ///< p_a, one after the other [k_n/d_s]
    std::string cell = "triclinic";            ///< which deformations the cell may make
    double inertia = 1;                        ///< beta, W in units of M L_ref^2/12
    std::optional<double> inertia_absolute;    ///< W itself, instead of `inertia` [rho d_s^5]
    double cell_damping = 4;                   ///< c, drag of the cell over (p_a V/W)^(1/2)
    std::optional<double> drag;                ///< g, the drag itself, instead of `cell_damping` [1/time]
    std::optional<double> time_step;           ///< [t_c]; empty: chosen by the program
    std::optional<double> time_step_absolute;  ///< instead of `time_step` [time]
    double mass_exponent = 3;                  ///< x: masses are proportional to d^x
    friend bool operator==(const Compaction&, const Compaction&) = default;
  };

  /// When the packing is at rest, and when to give up.
  struct Stop {
    std::string criterion = "rest";  ///< "rest", or "paper": the kinetic energy alone
    double stress_error = 1e-3;      ///< largest deviation of a stress component/p_a
    double force_imbalance = 1e-4;   ///< mean |net force| on the backbone/mean contact force
    double kinetic_energy = 1e-11;   ///< per particle [k_n d_s^2]
    double strain_drift = 1e-6;      ///< largest strain of the cell in 2000 t_c
    double window = 200;             ///< time over which all these limits must be met [t_c]
    double stilling = 100;  ///< all motion is set to zero when balance and drift are this near their limits
    double stilling_energy = 1e4;  ///< and the kinetic energy is this near its limit, or the forces balance;
    double growth = 1.15;          ///< not while the kinetic energy grows by more than this in half a window
    double phi_error = 0;          ///< ends the run as settled once phi can change by less; 0: never
    std::int64_t final_quenches = 0;  ///< how often all motion is set to zero at rest, before the verdict
    bool minimizer = true;            ///< without friction, ends the compaction by minimizing the enthalpy
    std::int64_t steps = 10'000'000;  ///< the cap on the steps of the run
    friend bool operator==(const Stop&, const Stop&) = default;
  };

  /// How the computer is used. Only `precision` changes the result.
  struct Compute {
    std::string precision = "mixed";  ///< "mixed", or "double": of forces and velocities
    std::optional<int> threads;       ///< empty: one per 2000 particles, at most all of the computer
    std::optional<double> skin;       ///< of the neighbour list; empty: chosen by the program [d_s]
    friend bool operator==(const Compute&, const Compute&) = default;
  };

  /// What is written, and how often.
  struct Output {
    std::int64_t history_every = 1000;  ///< steps between two rows of history.csv
    std::int64_t snapshot_every = 0;    ///< steps between two frames; 0: none by steps
    double snapshot_phi = 0;            ///< a frame at each multiple of this phi; 0: none by phi
    double checkpoint_minutes = 10;     ///< minutes of wall time between two checkpoints
    std::string picture = "fig1a";      ///< style of the final picture, or "none"
    int picture_size = 2000;            ///< edge of the square picture [pixels]
    std::string background = "white";   ///< "white" or "transparent"
    friend bool operator==(const Output&, const Output&) = default;
  };

  std::string preset = "none";  ///< source of the values that the file leaves out
  Mixture mixture;
  Start start;
  Contact contact;
  Compaction compaction;
  Stop stop;
  Compute compute;
  Output output;
  friend bool operator==(const Case&, const Case&) = default;
};

}  // namespace furnas
