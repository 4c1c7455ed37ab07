#include "io/case_preset.h"

#include <algorithm>

namespace furnas {

std::span<const Preset> presets() {
  static const std::vector<Preset> all{
      {"paper",
       "the protocol of arXiv 2105.00977: its contact law, its time step, its criterion of rest",
       {"contact.law=hooke_history", "contact.velocity=peculiar", "compaction.time_step=0.02",
        "stop.criterion=paper"}},
      {"reference",
       "the most careful: a short time step, all in double precision",
       {"compaction.time_step=0.02", "compute.precision=double"}},
      {"fast",
       "the fewest steps: large spheres are light and motion is stopped early, so that frictional mixtures "
       "are less dense",
       {"compaction.mass_exponent=2", "stop.stilling=1000", "stop.window=100"}},
  };
  return all;
}

std::span<const std::string_view> assignments_of(std::string_view preset) {
  const auto all = presets();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Preset& p) { return p.name == preset; });
  if (found == all.end()) return {};
  return found->assignments;
}

}  // namespace furnas
