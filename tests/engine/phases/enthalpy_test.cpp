#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/start/mixture.h"
#include "engine/trials/crystal.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

// Why kept_enthalpy H' is kept: with h' = e h a branch r changes at the rate v_i - v_j + e r, so
//   U' = - sum(F . v) - sum(e_ab V P^c_ba),           V P^c_ab = sum(r_a F_b) over contacts,
//   K' = sum(F . v) - sum(e_ab V P^k_ab) - tr(e) 2 K/(3 N),
//   (W/2) (sum e_ab^2)' = sum(e_ab V P_ba) - p_a V tr(e) + tr(e) 2 K/(3 N),
// and V' = V tr(e): all terms cancel. The bath is isotropic, so there is no work of a deviatoric stress.

Model undamped(const Packing& p, double pressure, double time_step = paper_step) {
  Model model = model_of<Frictionless<false>>({.normal_damping = 0}, time_step);
  model.barostat = {.pressure = pressure, .inertia = inertia_of_cell(p)};
  return model;
}

/// The particles of `p` in motion at about `speed`, with a total momentum of zero.
Packing stirred(Packing p, double speed, std::uint64_t seed) {
  test::Dice dice(seed);
  for (Vec3<double>& v : p.velocity) v = dice.vector(speed);
  const Vec3<double> drift = momentum(p) * (1 / p.sphere_volume());
  for (Vec3<double>& v : p.velocity) v -= drift;
  return p;
}

constexpr double crystal_pressure = 0.05;

/// A warm crystal whose contacts never open, in a cell that breathes and shears.
Packing warm_crystal() {
  Packing p = stirred(face_centred(0.97, 2), 3e-3, 1);
  p.cell.rate = {2e-3, -1e-3, 3e-3, 4e-3, -3e-3, 5e-3};
  return p;
}

constexpr double gas_pressure = 1e-3;

/// 200 spheres in flight, whose motion bears about the pressure of the bath.
Packing gas(std::uint64_t seed) {
  constexpr double speed = 0.05;
  return stirred(dilute_start({.large = 200, .start_fraction = 0.25, .seed = seed}), speed, seed);
}

/// Values of H' - H'(0) over `time`, once in each unit of time.
std::vector<double> wander(const Packing& start, double pressure, double time_step, double time) {
  const Model model = undamped(start, pressure, time_step);
  const auto simulation = make_simulation(model, start);
  const double first = kept_enthalpy(simulation->packing(), model.barostat);
  const auto every = static_cast<std::int64_t>(std::lround(1 / time_step));
  std::vector<double> values;
  for (double t = 0; t < time; t += static_cast<double>(every) * time_step) {
    simulation->advance(every);
    values.push_back(kept_enthalpy(simulation->packing(), model.barostat) - first);
  }
  return values;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (double x : values) sum += x * x;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Slope of the values times their number, by least squares.
double drift(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double sum = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    sum += values[k] * ((static_cast<double>(k) + 0.5) / count - 0.5);
  return 12 * sum / count;
}

// T40: in a crystal H' fluctuates by less than 1e-3 of the elastic energy, four times less with half
// the step, and does not drift: over 1e5 steps its slope amounts to less than a twentieth of its fluctuation.
TEST(Enthalpy, OfAWarmCrystalStays) {
  const Packing later = after(undamped(warm_crystal(), crystal_pressure), warm_crystal(), 1000);
  ASSERT_EQ(later.contacts.size(), 192u);
  const auto fluctuation = [](double time_step) {
    return root_mean_square(wander(warm_crystal(), crystal_pressure, time_step, 300));
  };
  const double coarse = fluctuation(2 * paper_step);
  const double fine = fluctuation(paper_step);
  EXPECT_NEAR(coarse / fine, 4, 0.2);
  EXPECT_LT(fine, 1e-3 * elastic_energy(later));
  const std::vector<double> values = wander(warm_crystal(), crystal_pressure, paper_step, 1e5 * paper_step);
  EXPECT_LT(std::abs(drift(values)), 0.05 * root_mean_square(values));
}

/// How H' of gases changes in a unit of time, and over the whole.
struct GasError {
  double jump;          ///< rms of the change in a unit of time
  double mean, spread;  ///< of the change over the whole, the latter of its mean
};

GasError gas_error(double time_step) {
  constexpr int gases = 16;
  constexpr double time = 60;
  GasError error{};
  double count = 0;
  for (int n = 1; n <= gases; ++n) {
    double before = 0;
    for (double now : wander(gas(static_cast<std::uint64_t>(n)), gas_pressure, time_step, time)) {
      error.jump += (now - before) * (now - before);
      before = now;
      ++count;
    }
    error.mean += before / gases;
    error.spread += before * before / gases;
  }
  return {std::sqrt(error.jump / count), error.mean, std::sqrt(error.spread / gases)};
}

// T40: in a gas each collision changes H' a little, this way or that, as its beginning and end lie in their
// steps (T2): a random walk, so what is compared is the change in a unit of time, over 16 gases. It falls by
// four with half the step, and its mean over the gases is zero within three standard errors. At twice the
// step of the paper terms of fourth order show in both.
TEST(Enthalpy, OfAGasStays) {
  const GasError coarse = gas_error(paper_step);
  const GasError fine = gas_error(paper_step / 2);
  EXPECT_NEAR(coarse.jump / fine.jump, 4, 0.4);
  EXPECT_LT(coarse.jump, 1e-4 * kinetic_energy(gas(1)));
  for (const GasError& error : {coarse, fine}) EXPECT_LT(std::abs(error.mean), 3 * error.spread);
}

// T31, T40: the motion of particles and cell goes back the way it came, the crystal's for 1e4 steps, that of
// a gas as long as chaos lets rounding be seen through. Measured: 3e-14.
TEST(Enthalpy, TheMotionIsReversible) {
  struct Journey {
    Packing start;
    double pressure;
    std::int64_t steps;
  };
  std::vector<Journey> journeys{{warm_crystal(), crystal_pressure, 10000}, {gas(1), gas_pressure, 500}};
  for (Journey& journey : journeys) {
    Packing& start = journey.start;
    start.cell.rate = {2e-3, -1e-3, 3e-3, 4e-3, -3e-3, 5e-3};
    const auto simulation = make_simulation(undamped(start, journey.pressure), start);
    const auto turn_back = [&] {
      Packing p = simulation->packing();
      for (Vec3<double>& v : p.velocity) v = -v;
      const Triangle& e = p.cell.rate;
      p.cell.rate = {-e.xx, -e.yy, -e.zz, -e.yz, -e.xz, -e.xy};
      simulation->load(p);
    };
    simulation->advance(journey.steps);
    EXPECT_GT(norm(simulation->packing().velocity[0] - start.velocity[0]), 1e-3);
    turn_back();
    simulation->advance(journey.steps);
    turn_back();
    const Packing back = simulation->packing();
    for (std::size_t k = 0; k < back.size(); ++k)
      ASSERT_LT(norm(back.unwrapped(k) - start.unwrapped(k)), 1e-12) << k;
    EXPECT_LT(largest_difference(back.velocity, start.velocity), 1e-12);
    EXPECT_LT(strain_between(start.cell.edges, back.cell.edges), 1e-12);
  }
}

}  // namespace
}  // namespace furnas
