#include "engine/analysis/analyze.h"

#include "engine/statistics/furnas_model.h"

namespace furnas {
namespace {

ContactAnalysis analyze_contacts(const Packing& p, const Selection& contacts, std::optional<PairKind> kind,
                                 const AnalysisOptions& options) {
  ContactAnalysis found;
  found.kind = kind;
  found.normal = normal_forces(p, contacts, options.force_bins);
  found.tangential = tangential_forces(p, contacts, options.force_bins);
  if (options.friction > 0) found.mobilisation = mobilisation(p, contacts, options.friction);
  found.fabric = fabric(p, contacts);
  return found;
}

NetworkAnalysis analyze_network(const Packing& p, const AnalysisOptions& options) {
  const std::vector<bool> live = live_contacts(p);
  const std::vector<bool> rattler = rattlers(p, live, options.backbone_threshold);
  const Selection all = all_contacts(p), backbone = backbone_contacts(p, live, rattler);
  NetworkAnalysis found;
  found.coordination = coordination(p);
  found.backbone_coordination = coordination(p, rattler, backbone);
  found.rattlers = rattler_sensitivity(p, {live_force_shares.begin(), live_force_shares.end()});
  found.fabric.push_back(fabric(p, all));
  found.backbone.push_back(analyze_contacts(p, backbone, {}, options));
  if (is_one_polydisperse_species(p)) return found;
  for (const PairKind kind : pair_kinds) {
    found.fabric.push_back(fabric(p, of_kind(p, all, kind)));
    const Selection some = of_kind(p, backbone, kind);
    if (!some.empty()) found.backbone.push_back(analyze_contacts(p, some, kind, options));
  }
  return found;
}

}  // namespace

Analysis analyze(const Packing& p, const AnalysisOptions& options) {
  Analysis found;
  double large_volume = 0, volume = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double cube = p.radius[k] * p.radius[k] * p.radius[k];
    const bool large = p.species[k] == Species::large;
    ++(large ? found.large : found.small);
    volume += cube;
    if (large) large_volume += cube;
  }
  found.sizes = sizes_of(p.radius);
  found.polydisperse = is_polydisperse(p);
  found.phi = p.fraction_filled();
  if (!found.polydisperse) {
    const double f_s = found.small == 0 ? 0 : 1 - large_volume / volume;
    found.mixture = {f_s, fraction_of_large(found.phi, f_s), fraction_in_voids(found.phi, f_s)};
  }
  found.backbone_threshold = options.backbone_threshold;
  found.friction = options.friction;
  if (!p.contacts.empty()) found.network = analyze_network(p, options);
  found.pairs = pair_correlation(p, options.pair_correlation);
  return found;
}

}  // namespace furnas
