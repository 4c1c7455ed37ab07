#pragma once

#include <optional>
#include <string>

#include "engine/compaction.h"

namespace furnas {

/// Watches what must hold in every run: faults of the packing (engine/monitor/faults.h), the momentum, the
/// balance of the energy, and that the neighbour list has missed no contact. Ends the run with a sentence.
class Monitor final : public Event {
 public:
  const char* name() const override { return "monitor"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 1000); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override { return now.diverged(sentence_); }
  std::string saved() override;
  void restore(const std::string& saved) override;

 private:
  /// What the momentum is compared with.
  struct Momentum {
    Vec3<double> sum;         ///< sum m v [rho d_s^4/time]
    double spread{};          ///< root of sum (m v)^2, the momentum that chance would leave
    Triangle edges;           ///< of the cell [d_s]
    std::int64_t step{};      ///< when it was taken
    std::int64_t replaced{};  ///< how often an event had changed the packing
  };
  static Momentum momentum_of(Observation& now);
  std::string momentum_fault(Observation& now);

  std::optional<Momentum> last_;
  std::string sentence_;
};

/// Largest gap in the balance of the energy, over the energy that went through.
inline constexpr double largest_energy_gap = 0.1;

}  // namespace furnas
