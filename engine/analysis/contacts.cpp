#include "engine/analysis/contacts.h"

#include <numeric>

namespace furnas {

Selection all_contacts(const Packing& p) {
  Selection all(p.contacts.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

Selection backbone_contacts(const Packing& p, const std::vector<bool>& live,
                            const std::vector<bool>& rattler) {
  Selection chosen;
  for (std::size_t n = 0; n < p.contacts.size(); ++n)
    if (live[n] && !rattler[p.contacts[n].i] && !rattler[p.contacts[n].j]) chosen.push_back(n);
  return chosen;
}

Selection of_kind(const Packing& p, const Selection& contacts, PairKind kind) {
  Selection chosen;
  for (const std::size_t n : contacts)
    if (kind_of(p, p.contacts[n]) == kind) chosen.push_back(n);
  return chosen;
}

}  // namespace furnas
