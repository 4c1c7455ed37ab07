#include <fmt/format.h>

#include <algorithm>

#include "cases/program/bench/speed.h"
#include "engine/state/fingerprint.h"

namespace furnas {

Table speed_table(const std::vector<SpeedRow>& rows, const std::vector<double>& bandwidth) {
  Table table({"packing", "N", "mu", "precision", "threads", "Mps", "range", "B/step", "bound", "pairs/N",
               "inner/N", "contacts/N", "rebuilds/steps", "B/N", "error", "largest", "mistaken", "state"});
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const SpeedRow& r = rows[k];
    table.row({r.packing, fmt::format("{}", r.particles), fmt::format("{:g}", r.friction),
               r.variant.precision, fmt::format("{}", r.variant.threads),
               fmt::format("{:.3g}", r.rate.median), fmt::format("{:.3g} - {:.3g}", r.rate.low, r.rate.high),
               fmt::format("{:.0f}", r.moved), fmt::format("{:.3g}", bandwidth[k] / r.moved / 1e6),
               fmt::format("{:.2f}", r.pairs), fmt::format("{:.2f}", r.inner),
               fmt::format("{:.2f}", r.contacts), fmt::format("{}/{}", r.rebuilds, r.steps),
               fmt::format("{:.0f}", r.memory), fmt::format("{:.1e}", r.error.median),
               fmt::format("{:.1e}", r.error.largest), fmt::format("{:g}", r.error.mistaken()), hex(r.hash)});
  }
  return table;
}

Table speed_csv(const std::vector<SpeedRow>& rows, const std::vector<double>& bandwidth) {
  std::vector<std::string> names{"packing",
                                 "particles",
                                 "friction",
                                 "precision",
                                 "threads",
                                 "steps",
                                 "rate_median",
                                 "rate_low",
                                 "rate_high",
                                 "bytes_per_step",
                                 "bandwidth",
                                 "bound",
                                 "pairs",
                                 "inner_pairs",
                                 "contacts",
                                 "rebuilds",
                                 "bytes_per_particle",
                                 "error_median",
                                 "error_largest",
                                 "contacts_missed",
                                 "contacts_spurious",
                                 "state_hash"};
  std::vector<std::string> phases;
  for (const SpeedRow& row : rows)
    for (const auto& [title, share] : row.shares)
      if (std::find(phases.begin(), phases.end(), title) == phases.end()) phases.push_back(title);
  names.insert(names.end(), phases.begin(), phases.end());
  Table table(names);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const SpeedRow& r = rows[k];
    const auto real = [](double value) { return fmt::format("{:.6g}", value); };
    const auto whole = [](auto value) { return fmt::format("{}", value); };
    std::vector<std::string> cells{r.packing,
                                   whole(r.particles),
                                   real(r.friction),
                                   r.variant.precision,
                                   whole(r.variant.threads),
                                   whole(r.steps),
                                   real(r.rate.median),
                                   real(r.rate.low),
                                   real(r.rate.high),
                                   real(r.moved),
                                   real(bandwidth[k]),
                                   real(bandwidth[k] / r.moved / 1e6),
                                   real(r.pairs),
                                   real(r.inner),
                                   real(r.contacts),
                                   whole(r.rebuilds),
                                   real(r.memory),
                                   real(r.error.median),
                                   real(r.error.largest),
                                   whole(r.error.missed),
                                   whole(r.error.spurious),
                                   hex(r.hash)};
    for (const std::string& title : phases) {
      const auto found = std::find_if(r.shares.begin(), r.shares.end(),
                                      [&](const auto& share) { return share.first == title; });
      cells.push_back(real(found == r.shares.end() ? 0 : found->second));
    }
    table.row(cells);
  }
  return table;
}

std::string phase_lines(const std::vector<SpeedRow>& rows) {
  constexpr double least = 0.005;
  std::string text;
  for (const SpeedRow& r : rows) {
    text += fmt::format("{}, {} particles, mu {:g}, {}, {} thread{}:", r.packing, r.particles, r.friction,
                        r.variant.precision, r.variant.threads, r.variant.threads == 1 ? "" : "s");
    auto shares = r.shares;
    std::stable_sort(shares.begin(), shares.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    const char* separator = " ";
    for (const auto& [title, share] : shares) {
      if (share < least) break;
      text += fmt::format("{}{} {:.0f} %", separator, title, 100 * share);
      separator = ", ";
    }
    text += '\n';
  }
  return text;
}

}  // namespace furnas
