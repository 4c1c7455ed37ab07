#include "engine/analysis/rattlers.h"

#include <array>
#include <cstddef>
#include <limits>
#include <numeric>

#include "engine/analysis/contacts.h"
#include "engine/base/require.h"

namespace furnas {

std::vector<bool> live_contacts(const Packing& p, double share) {
  std::array<double, 3> sum{};
  std::array<std::size_t, 3> count{};
  for (const Contact& c : p.contacts) {
    const auto k = static_cast<std::size_t>(kind_of(p, c));
    sum[k] += normal_force(c);
    ++count[k];
  }
  std::vector<bool> live;
  live.reserve(p.contacts.size());
  for (const Contact& c : p.contacts) {
    const auto k = static_cast<std::size_t>(kind_of(p, c));
    const double force = normal_force(c);
    live.push_back(force > 0 && force * static_cast<double>(count[k]) > share * sum[k]);
  }
  return live;
}

std::vector<bool> rattlers(const Packing& p, const std::vector<bool>& live, int least_contacts) {
  // The partners of k will be at [first[k], first[k + 1]). Each range is filled from its end, so that
  // first[k] moves from the end of the range to its beginning.
  require(2 * p.contacts.size() < std::numeric_limits<std::uint32_t>::max(), "contacts fit in 31 bits");
  std::vector<std::uint32_t> first(p.size() + 1, 0);
  for (std::size_t n = 0; n < p.contacts.size(); ++n)
    if (live[n]) ++first[p.contacts[n].i], ++first[p.contacts[n].j];
  std::vector<std::uint32_t> degree(first.begin(), first.end() - 1);
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> partner(first.back());
  for (std::size_t n = 0; n < p.contacts.size(); ++n) {
    if (!live[n]) continue;
    const Contact& c = p.contacts[n];
    partner[--first[c.i]] = c.j;
    partner[--first[c.j]] = c.i;
  }

  const auto least = static_cast<std::uint32_t>(least_contacts);
  std::vector<bool> out(p.size(), false);
  std::vector<std::uint32_t> gone;  // removed particles whose partners' counts are not yet reduced
  for (std::uint32_t k = 0; k < p.size(); ++k) {
    if (out[k] || degree[k] >= least) continue;
    out[k] = true;
    gone.push_back(k);
    while (!gone.empty()) {
      const std::uint32_t left = gone.back();
      gone.pop_back();
      for (std::uint32_t n = first[left]; n < first[left + 1]; ++n) {
        const std::uint32_t other = partner[n];
        if (out[other] || --degree[other] >= least) continue;
        out[other] = true;
        gone.push_back(other);
      }
    }
  }
  return out;
}

RattlerCount count_rattlers(const Packing& p, const std::vector<bool>& live, const std::vector<bool>& rattler,
                            int least_contacts) {
  RattlerCount count;
  count.least_contacts = least_contacts;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (!rattler[k])
      ++count.backbone;
    else
      ++(p.species[k] == Species::large ? count.large : count.small);
  }
  for (std::size_t n = 0; n < p.contacts.size(); ++n)
    if (live[n] && !rattler[p.contacts[n].i] && !rattler[p.contacts[n].j]) ++count.contacts;
  if (count.backbone > 0)
    count.coordination = 2 * static_cast<double>(count.contacts) / static_cast<double>(count.backbone);
  return count;
}

std::vector<RattlerSensitivity> rattler_sensitivity(const Packing& p, const std::vector<double>& shares) {
  std::vector<RattlerSensitivity> rows;
  for (const int least_contacts : {2, 3, 4})
    for (const double share : shares) {
      const std::vector<bool> live = live_contacts(p, share);
      rows.push_back({share, count_rattlers(p, live, rattlers(p, live, least_contacts), least_contacts)});
    }
  return rows;
}

}  // namespace furnas
