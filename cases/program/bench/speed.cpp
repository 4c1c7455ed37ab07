#include "cases/program/bench/speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>

#include "cases/program/bench/memory.h"
#include "cases/program/bench/roofline.h"
#include "engine/simulation.h"
#include "engine/state/fingerprint.h"

namespace furnas {
namespace {

double seconds_of(Simulation& simulation, std::int64_t steps) {
  const auto begin = std::chrono::steady_clock::now();
  simulation.advance(steps);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The share of each phase in the time of these steps; phases of the same name are added.
std::vector<std::pair<std::string, double>> shares_of_phases(Simulation& simulation, std::int64_t steps) {
  std::vector<PhaseTime> times;
  simulation.graph().keep_times(&times);
  simulation.advance(steps);
  simulation.graph().keep_times(nullptr);
  const std::vector<std::string> titles = simulation.graph().titles();
  std::vector<std::pair<std::string, double>> shares;
  double sum = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto same =
        std::find_if(shares.begin(), shares.end(), [&](const auto& s) { return s.first == titles[k]; });
    (same == shares.end() ? shares.emplace_back(titles[k], 0) : *same).second += times[k].seconds;
    sum += times[k].seconds;
  }
  for (auto& [title, share] : shares) share /= std::max(sum, 1e-300);
  return shares;
}

/// All variants on one packing.
class SpeedMeasurement {
 public:
  SpeedMeasurement(const std::string& name, const Packing& packing, const SpeedOrder& order)
      : packing_(packing), order_(order), rates_(order.variants.size()), rows_(order.variants.size()) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      rows_[k].packing = name;
      rows_[k].particles = packing.size();
      rows_[k].friction = order.friction;
      rows_[k].variant = order.variants[k];
    }
  }

  std::vector<SpeedRow> run() {
    steps_ = order_.steps > 0 ? order_.steps : calibrated_steps();
    for (int n = 0; n < order_.repeats; ++n)
      for (std::size_t k = 0; k < rows_.size(); ++k) repeat(k, n + 1 == order_.repeats);
    for (std::size_t k = 0; k < rows_.size(); ++k) finish(k);
    return std::move(rows_);
  }

 private:
  Model model(std::size_t k) const {
    return model_for({order_.law, order_.friction, order_.variants[k].precision}, packing_);
  }

  std::int64_t calibrated_steps() const {
    const auto simulation = make_simulation(model(0), packing_, order_.variants[0].threads);
    constexpr double long_enough = 0.05;
    constexpr std::int64_t fewest = 10;
    std::int64_t steps = 2;
    double seconds = seconds_of(*simulation, steps);
    while (seconds < std::min(long_enough, order_.seconds)) seconds = seconds_of(*simulation, steps *= 2);
    return std::max<std::int64_t>(fewest,
                                  std::llround(order_.seconds * static_cast<double>(steps) / seconds));
  }

  void repeat(std::size_t k, bool last) {
    SpeedRow& row = rows_[k];
    const MemoryWatch memory;
    const auto simulation = make_simulation(model(k), packing_, order_.variants[k].threads);
    const auto particles = static_cast<double>(packing_.size());
    // After these steps caches and pages are warm. The first neighbour list, which is wide because the motion
    // was unknown, has been replaced.
    constexpr std::int64_t settled = 150;
    simulation->advance(std::max(steps_ / 10, settled));
    const std::int64_t builds = simulation->neighbours().builds;
    rates_[k].push_back(particles * static_cast<double>(steps_) / seconds_of(*simulation, steps_) / 1e6);
    row.rebuilds = simulation->neighbours().builds - builds;
    row.memory = std::max(row.memory, static_cast<double>(memory.growth()) / particles);
    row.pairs = static_cast<double>(simulation->neighbours().pairs) / particles;
    row.inner = static_cast<double>(simulation->neighbours().inner_pairs) / particles;
    {
      const Packing now = simulation->packing();
      row.contacts = static_cast<double>(now.contacts.size()) / particles;
      row.hash = state_hash(now);
    }
    check_hash(row);
    if (last) row.shares = shares_of_phases(*simulation, steps_ / 5 + 1);
  }

  void check_hash(const SpeedRow& row) {
    const auto [first, fresh] = hashes_.try_emplace(row.variant.precision, row.hash);
    if (first->second != row.hash)
      throw std::runtime_error(fmt::format(
          "{} particles, {} precision, {} threads: the state hash is {}, {} before", row.particles,
          row.variant.precision, row.variant.threads, hex(row.hash), hex(first->second)));
  }

  void finish(std::size_t k) {
    SpeedRow& row = rows_[k];
    row.steps = steps_;
    row.rate = spread_of(rates_[k]);
    row.moved = bytes_per_particle_step(
        {has_friction(model(k).law), row.inner, model(k).precision == Precision::mixed});
    const auto known = errors_.find(row.variant.precision);
    row.error = known != errors_.end() ? known->second : force_error(model(k), packing_, row.variant.threads);
    errors_[row.variant.precision] = row.error;
  }

  const Packing& packing_;
  const SpeedOrder& order_;
  std::int64_t steps_ = 0;
  std::vector<std::vector<double>> rates_;
  std::vector<SpeedRow> rows_;
  std::map<std::string, std::uint64_t> hashes_;  ///< by precision
  std::map<std::string, ForceError> errors_;     ///< by precision
};

}  // namespace

std::vector<SpeedRow> measure_speed(const std::string& name, const Packing& packing,
                                    const SpeedOrder& order) {
  return SpeedMeasurement(name, packing, order).run();
}

}  // namespace furnas
