#pragma once

#include <optional>
#include <string>

#include "engine/compaction.h"

namespace furnas {

/// Checks conditions that every run must meet: no faults of the packing (engine/monitor/faults.h), conserved
/// momentum, balanced energy, and a neighbour list that misses no contact. If a check fails, ends the run
/// with a sentence that describes the fault.
class Monitor final : public Event {
 public:
  const char* name() const override { return "monitor"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 1000); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override { return now.diverged(sentence_); }
  std::string saved() override;
  void restore(const std::string& saved) override;

 private:
  /// The momentum at one check, for comparison with the next check.
  struct Momentum {
    Vec3<double> sum;         ///< sum m v [rho d_s^4/time]
    double spread{};          ///< root of sum (m v)^2, the momentum of random velocities
    Triangle edges;           ///< of the cell [d_s]
    std::int64_t step{};      ///< of the check
    std::int64_t replaced{};  ///< how often events had changed the packing
  };
  static Momentum momentum_of(Observation& now);
  std::string momentum_fault(Observation& now);

  std::optional<Momentum> last_;
  std::string sentence_;
};

/// Largest allowed gap in the energy balance, as a share of the energy turnover (Ledger::relative_gap).
inline constexpr double largest_energy_gap = 0.1;

}  // namespace furnas
