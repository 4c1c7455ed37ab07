#include "cases/program/bench/peers.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "cases/program/lammps_kit.h"
#include "cases/program/packing_source.h"
#include "engine/base/require.h"
#include "engine/simulation.h"

namespace furnas {
namespace {

/// The start, in the form that LAMMPS reads.
Packing start_from(const PeersOrder& order) {
  Packing start = for_lammps(packing_source(order.source, order.frame).packing);
  start.step = 0;
  start.time = 0;
  return start;
}

double rate(const Packing& packing, std::int64_t steps, double seconds) {
  return static_cast<double>(packing.size()) * static_cast<double>(steps) / seconds / 1e6;
}

/// Furnas and LAMMPS on one packing.
class Match {
 public:
  Match(const PeersOrder& order, Console console)
      : order_(order),
        console_(console),
        start_(start_from(order)),
        legacy_(model_for({"hooke_history", order.model.friction, order.model.precision}, start_)),
        lammps_(order.folder, start_, legacy_, order.ranks) {}

  void tune() {
    const bool one_size = *std::max_element(start_.radius.begin(), start_.radius.end()) ==
                          *std::min_element(start_.radius.begin(), start_.radius.end());
    const std::int64_t steps = std::max<std::int64_t>(order_.steps / 2, 1);
    Table table({"style", "skin", "LAMMPS Mps", "rebuilds/steps"});
    for (const char* style : {"bin", "multi"}) {
      if (one_size && std::string_view(style) == "multi") continue;  // "multi" is for several sizes
      for (const double skin : order_.skins) {
        const LammpsSetting setting{style, skin};
        if (const auto timing = attempt(setting, steps)) {
          const double mps = rate(start_, steps, timing->seconds);
          table.row({style, fmt::format("{:g}", skin), fmt::format("{:.3g}", mps),
                     fmt::format("{}/{}", timing->rebuilds, steps)});
          if (mps > best_rate_) best_rate_ = mps, best_ = setting;
        }
      }
    }
    if (best_rate_ == 0) throw std::runtime_error("LAMMPS: no setting works");
    console_.out << table.aligned() << fmt::format("best: {}, skin {:g}\n\n", best_.style, best_.skin)
                 << std::flush;
  }

  void play() {
    const Model model = model_for(order_.model, start_);
    std::vector<double> ours, theirs, ratios;
    Table table({"pair", "furnas Mps", "LAMMPS Mps", "ratio", "furnas rebuilds", "LAMMPS rebuilds"});
    for (int n = 0; n < order_.pairs; ++n) {
      const auto simulation = make_simulation(model, start_, order_.ranks);
      const std::int64_t builds = simulation->neighbours().builds;
      const auto begin = std::chrono::steady_clock::now();
      simulation->advance(order_.steps);
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
      ours.push_back(rate(start_, order_.steps, time.count()));
      const LammpsTiming timing = lammps_.run(best_, order_.steps);
      theirs.push_back(rate(start_, order_.steps, timing.seconds));
      ratios.push_back(ours.back() / theirs.back());
      table.row({fmt::format("{}", n + 1), fmt::format("{:.3g}", ours.back()),
                 fmt::format("{:.3g}", theirs.back()), fmt::format("{:.3g}", ratios.back()),
                 fmt::format("{}", simulation->neighbours().builds - builds),
                 fmt::format("{}", timing.rebuilds)});
    }
    console_.out << table.aligned()
                 << fmt::format("furnas  {} Mps, {}, mu {:g}, {}, {} thread(s)\n", text_of(spread_of(ours)),
                                order_.model.law, order_.model.friction, order_.model.precision, order_.ranks)
                 << fmt::format("LAMMPS  {} Mps, gran/hooke/history, {} rank(s)\n",
                                text_of(spread_of(theirs)), order_.ranks)
                 << fmt::format("ratio   {}\n", text_of(spread_of(ratios)));
  }

  void compare_forces() {
    const Packing ours = make_simulation(legacy_, start_)->packing();
    const ForceDifference d = difference_of_forces(ours, lammps_.forces().force);
    console_.out << fmt::format(
        "forces  differ by {:.1e} (median), {:.1e} (largest) at the start, hooke_history\n", d.median,
        d.largest);
  }

  void introduce() const {
    console_.out << fmt::format("{}: {} particles, {} steps a run, million particle-steps per second (Mps)\n",
                                order_.source, start_.size(), order_.steps)
                 << std::flush;
  }

 private:
  /// A setting with which LAMMPS fails is reported in a line and left out of the comparison.
  std::optional<LammpsTiming> attempt(const LammpsSetting& setting, std::int64_t steps) const {
    try {
      return lammps_.run(setting, steps);
    } catch (const std::runtime_error& error) {
      console_.err << fmt::format("{}, skin {:g}: {}\n", setting.style, setting.skin, error.what());
      return {};
    }
  }

  const PeersOrder& order_;
  Console console_;
  Packing start_;
  Model legacy_;
  Lammps lammps_;
  LammpsSetting best_;
  double best_rate_ = 0;
};

}  // namespace

ForceDifference difference_of_forces(const Packing& ours, const std::vector<Vec3<double>>& theirs) {
  if (theirs.size() != ours.size())
    throw std::runtime_error("LAMMPS: its dump has another number of particles");
  std::vector<double> scale(ours.size());
  for (const Contact& c : ours.contacts) {
    scale[c.i] += norm(c.force);
    scale[c.j] += norm(c.force);
  }
  std::vector<double> differences;
  for (std::size_t k = 0; k < ours.size(); ++k)
    if (const double d = norm(ours.force[k] - theirs[k]); scale[k] > 0 || d > 0)
      differences.push_back(d / std::max(scale[k], 1e-300));
  if (differences.empty()) return {};
  const Spread spread = spread_of(differences);
  return {spread.median, spread.high};
}

ExitCode compare_with_lammps(const PeersOrder& order, Console console) {
  Match match(order, console);
  match.introduce();
  match.tune();
  match.play();
  match.compare_forces();
  return ExitCode::done;
}

}  // namespace furnas
