#include "io/analysis_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/require.h"
#include "io/json_text.h"

namespace furnas {
namespace {

using Json = nlohmann::ordered_json;

// clang-format off
constexpr OutputField coordination_fields[] = {
    {"particles", "", "each row", "all particles of the packing, or those of its backbone"},
    {"species", "", "each row", "large, small, or all of a polydisperse packing"},
    {"count", "", "total", "particles of this species"},
    {"contacts_with_large", "", "per particle of this species", "contacts with large spheres"},
    {"contacts_with_small", "", "per particle of this species", "contacts with small spheres"},
    {"contacts", "", "per particle of this species", "contacts with all"},
};
constexpr OutputField rattlers_fields[] = {
    {"least_contacts", "", "each row", "z_min: particles with fewer live contacts are removed until none is left; they are the rattlers"},
    {"live_force_share", "mean F_n of its kind", "each row", "a contact is live if its normal force exceeds this"},
    {"large", "", "total", "large spheres that are rattlers"},
    {"small", "", "total", "small spheres that are rattlers"},
    {"large_share", "", "share of the large spheres", "the same"},
    {"small_share", "", "share of the small spheres", "the same"},
    {"backbone", "", "total", "particles that are no rattlers"},
    {"contacts", "", "total", "live contacts between them"},
    {"coordination", "", "per particle of the backbone", "2 contacts/backbone"},
};
constexpr OutputField forces_fields[] = {
    {"force", "", "each row", "normal: F_n; tangential: abs(F_t)"},
    {"kind", "", "each row", "kind of the contacts in the backbone: all, large-large, large-small, small-small"},
    {"low", "mean force", "each bin", "lower edge of the bin, in units of the mean of this force over these contacts"},
    {"high", "mean force", "each bin", "upper edge"},
    {"count", "", "total", "contacts in the bin"},
    {"density", "", "each bin", "probability density of force/mean: share of the contacts over the width of the bin"},
};
constexpr OutputField mobilisation_fields[] = {
    {"kind", "", "each row", "kind of the contacts in the backbone, as in forces.csv"},
    {"low", "", "each bin", "lower edge of the bin of abs(F_t)/(mu F_n), which is 1 where a contact slides"},
    {"high", "", "each bin", "upper edge"},
    {"count", "", "total", "contacts in the bin"},
    {"density", "", "each bin", "probability density: share of the contacts over the width of the bin"},
};
constexpr OutputField fabric_fields[] = {
    {"contacts_of", "", "each row", "all contacts, or those of the backbone"},
    {"kind", "", "each row", "kind of the contacts, as in forces.csv"},
    {"contacts", "", "total", "number of contacts"},
    {"xx", "", "mean of the contacts", "fabric tensor, the mean of n_a n_b with the unit normal n; 1/3 on the diagonal if no direction is preferred"},
    {"yy", "", "mean of the contacts", "the same"},
    {"zz", "", "mean of the contacts", "the same"},
    {"xy", "", "mean of the contacts", "the same"},
    {"xz", "", "mean of the contacts", "the same"},
    {"yz", "", "mean of the contacts", "the same"},
    {"anisotropy", "", "each row", "(3/2)^(1/2) times the norm of tensor - 1/3: 0 if no direction is preferred, 1 if all normals are parallel"},
    {"anisotropy_by_chance", "", "each row", "root mean square anisotropy of as many random directions, contacts^(-1/2)"},
};
constexpr OutputField pair_correlation_fields[] = {
    {"kind", "", "each row", "kind of the pairs: all, large-large, large-small, small-small"},
    {"low", "d_s", "each bin", "lower edge of the bin of distances r between centres"},
    {"high", "d_s", "each bin", "upper edge"},
    {"count", "", "total", "pairs in the bin, counted from the particles from which distances were measured"},
    {"g", "", "each bin", "g(r): pairs in the bin over those of an ideal gas of the same density"},
    {"error", "", "each bin", "standard deviation of g in an ideal gas with these counts"},
    {"neighbours", "", "per particle", "partners nearer than the upper edge, on average"},
};
// clang-format on

/// The first line of a table.
std::string header(std::span<const OutputField> fields) {
  std::string line;
  for (const OutputField& field : fields) {
    line += field.name;
    line += ',';
  }
  line.back() = '\n';
  return line;
}

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// A count of one species; null where large and small spheres are not distinguished.
Json of_species(const Analysis& a, std::int64_t count) {
  return a.has_species() ? Json(count) : Json(nullptr);
}

Json as_json(const Coordination& c, const Analysis& a) {
  const auto of = [&](Species species, std::int64_t count) {
    if (count == 0 || !a.has_species()) return Json(nullptr);
    return Json{{"with_large", c.of(species, Species::large)},
                {"with_small", c.of(species, Species::small)},
                {"with_all", c.of(species)}};
  };
  return {{"Z", c.mean()},
          {"particles", c.particles()},
          {"large", of_species(a, c.large)},
          {"small", of_species(a, c.small)},
          {"contacts", c.all_contacts()},
          {"large_large_contacts", of_species(a, c.contacts[0])},
          {"large_small_contacts", of_species(a, c.contacts[1])},
          {"small_small_contacts", of_species(a, c.contacts[2])},
          {"contacts_of_a_large_sphere", of(Species::large, c.large)},
          {"contacts_of_a_small_sphere", of(Species::small, c.small)}};
}

Json as_json(const Fabric& f) {
  const auto& t = f.tensor;
  return {{"contacts", f.contacts},
          {"tensor", {{"xx", t[0]}, {"yy", t[1]}, {"zz", t[2]}, {"xy", t[3]}, {"xz", t[4]}, {"yz", t[5]}}},
          {"anisotropy", f.anisotropy()},
          {"anisotropy_by_chance", f.anisotropy_by_chance()}};
}

Json as_json(const ContactAnalysis& c) {
  Json json = {{"kind", name_of(c.kind)},
               {"contacts", c.normal.contacts},
               {"mean_normal_force", c.normal.mean},
               {"largest_normal_force", c.normal.largest},
               {"mean_tangential_force", c.tangential.mean},
               {"largest_tangential_force", c.tangential.largest}};
  if (c.mobilisation) {
    json["mean_mobilisation"] = c.mobilisation->mean;
    json["sliding_share"] = c.mobilisation->sliding_share();
    json["beyond_friction"] = c.mobilisation->beyond;
  }
  json["fabric"] = as_json(c.fabric);
  return json;
}

Json as_json(const NetworkAnalysis& n, const Analysis& a) {
  Json json = {{"coordination", as_json(n.coordination, a)},
               {"backbone_threshold", a.backbone_threshold},
               {"backbone_coordination", as_json(n.backbone_coordination, a)}};
  for (const RattlerSensitivity& row : n.rattlers)
    json["rattlers"].push_back({{"least_contacts", row.count.least_contacts},
                                {"live_force_share", row.share},
                                {"large", of_species(a, row.count.large)},
                                {"small", of_species(a, row.count.small)},
                                {"backbone", row.count.backbone},
                                {"contacts", row.count.contacts},
                                {"coordination", row.count.coordination}});
  for (std::size_t k = 0; k < n.fabric.size(); ++k) {
    if (n.fabric[k].contacts == 0) continue;
    Json fabric = {{"kind", name_of(k == 0 ? std::nullopt : std::optional(pair_kinds[k - 1]))}};
    fabric.update(as_json(n.fabric[k]));
    json["fabric"].push_back(fabric);
  }
  for (const ContactAnalysis& c : n.backbone) json["backbone"].push_back(as_json(c));
  return json;
}

Json as_json(const PairCorrelation& p) {
  const auto highest = std::max_element(p.g.begin(), p.g.end()) - p.g.begin();
  return {
      {"kind", name_of(p.kind)},
      {"contact_distance", p.contact},
      {"origins", p.origins},
      {"reach", p.edges.back()},
      {"bin", p.edges[1]},
      {"highest",
       {{"r", p.centre(static_cast<std::size_t>(highest))}, {"g", p.g[static_cast<std::size_t>(highest)]}}}};
}

std::string summary(const AnalysisRecord& r) {
  const Analysis& a = r.analysis;
  Json json = {{"source", r.source},
               {"step", r.step},
               {"phi_J", r.phi_J ? Json(*r.phi_J) : Json(nullptr)},
               {"phi", a.phi},
               {"small_fraction", a.mixture ? Json(a.mixture->small_fraction) : Json(nullptr)},
               {"phi_L", a.mixture ? Json(a.mixture->phi_large) : Json(nullptr)},
               {"phi_S", a.mixture ? Json(a.mixture->phi_small) : Json(nullptr)},
               {"particles", a.large + a.small},
               {"large", of_species(a, a.large)},
               {"small", of_species(a, a.small)},
               {"polydisperse", a.polydisperse},
               {"sizes", a.sizes.count},
               {"smallest_diameter", a.sizes.smallest},
               {"largest_diameter", a.sizes.largest},
               {"friction", a.friction},
               {"contacts_are", !a.network                ? Json(nullptr)
                                : r.contacts_are_overlaps ? Json("overlaps")
                                                          : Json("of the source")}};
  if (a.network) json["network"] = as_json(*a.network, a);
  json["pair_correlation"] = Json::array();
  for (const PairCorrelation& p : a.pairs) json["pair_correlation"].push_back(as_json(p));
  return json_text(json);
}

std::string coordination_table(const AnalysisRecord& r) {
  if (!r.analysis.network) return {};
  std::string text = header(coordination_fields);
  const auto rows = [&](const char* particles, const Coordination& c) {
    if (!r.analysis.has_species()) {
      text += fmt::format("{},all,{},,,{}\n", particles, c.particles(), c.mean());
      return;
    }
    if (c.large > 0)
      text += fmt::format("{},large,{},{},{},{}\n", particles, c.large, c.of(Species::large, Species::large),
                          c.of(Species::large, Species::small), c.of(Species::large));
    if (c.small > 0)
      text += fmt::format("{},small,{},{},{},{}\n", particles, c.small, c.of(Species::small, Species::large),
                          c.of(Species::small, Species::small), c.of(Species::small));
  };
  rows("all", r.analysis.network->coordination);
  rows("backbone", r.analysis.network->backbone_coordination);
  return text;
}

std::string rattlers_table(const AnalysisRecord& r) {
  if (!r.analysis.network) return {};
  std::string text = header(rattlers_fields);
  const Analysis& a = r.analysis;
  for (const auto& [live_share, c] : a.network->rattlers) {
    const std::string of_species =
        a.has_species()
            ? fmt::format("{},{},{},{}", c.large, c.small, share(c.large, a.large), share(c.small, a.small))
            : ",,,";
    text += fmt::format("{},{},{},{},{},{}\n", c.least_contacts, live_share, of_species, c.backbone,
                        c.contacts, c.coordination);
  }
  return text;
}

void add_rows(std::string& text, const std::string& begin, const Histogram& h) {
  for (std::size_t b = 0; b < h.bins(); ++b)
    text += fmt::format("{},{:.12g},{:.12g},{},{}\n", begin, h.edges[b], h.edges[b + 1], h.counts[b],
                        h.density(b));
}

std::string forces_table(const AnalysisRecord& r) {
  if (!r.analysis.network) return {};
  std::string text = header(forces_fields);
  for (const ContactAnalysis& c : r.analysis.network->backbone) {
    add_rows(text, fmt::format("normal,{}", name_of(c.kind)), c.normal.histogram);
    add_rows(text, fmt::format("tangential,{}", name_of(c.kind)), c.tangential.histogram);
  }
  return text;
}

std::string mobilisation_table(const AnalysisRecord& r) {
  if (!r.analysis.network || r.analysis.friction == 0) return {};
  std::string text = header(mobilisation_fields);
  for (const ContactAnalysis& c : r.analysis.network->backbone)
    if (c.mobilisation) add_rows(text, std::string(name_of(c.kind)), c.mobilisation->histogram);
  return text;
}

std::string fabric_table(const AnalysisRecord& r) {
  if (!r.analysis.network) return {};
  std::string text = header(fabric_fields);
  const auto row = [&](const char* of, const std::optional<PairKind>& kind, const Fabric& f) {
    if (f.contacts > 0)
      text += fmt::format("{},{},{},{},{},{}\n", of, name_of(kind), f.contacts, fmt::join(f.tensor, ","),
                          f.anisotropy(), f.anisotropy_by_chance());
  };
  const auto& network = *r.analysis.network;
  for (std::size_t k = 0; k < network.fabric.size(); ++k)
    row("all", k == 0 ? std::nullopt : std::optional(pair_kinds[k - 1]), network.fabric[k]);
  for (const ContactAnalysis& c : network.backbone) row("backbone", c.kind, c.fabric);
  return text;
}

std::string pair_correlation_table(const AnalysisRecord& r) {
  if (r.analysis.pairs.empty()) return {};
  std::string text = header(pair_correlation_fields);
  for (const PairCorrelation& p : r.analysis.pairs)
    for (std::size_t b = 0; b < p.g.size(); ++b)
      text += fmt::format("{},{:.12g},{:.12g},{},{},{},{}\n", name_of(p.kind), p.edges[b], p.edges[b + 1],
                          p.counts[b], p.g[b], p.error[b], p.neighbours[b]);
  return text;
}

// clang-format off
constexpr AnalysisFile table[] = {
    {"analysis.json", "The means of all tables, and numbers of the whole packing.", {}, summary},
    {"coordination.csv", "How many contacts a sphere has.", coordination_fields, coordination_table},
    {"rattlers.csv", "How the number of rattlers depends on what counts as a contact and on how many contacts hold a sphere.", rattlers_fields, rattlers_table},
    {"forces.csv", "Histograms of the contact forces in the backbone.", forces_fields, forces_table},
    {"mobilisation.csv", "How far the contacts of the backbone are from sliding; only with friction.", mobilisation_fields, mobilisation_table},
    {"fabric.csv", "The directions of the contacts.", fabric_fields, fabric_table},
    {"pair_correlation.csv", "The pair correlation g(r).", pair_correlation_fields, pair_correlation_table},
};
// clang-format on

}  // namespace

std::span<const AnalysisFile> analysis_files() { return table; }

std::string_view name_of(const std::optional<PairKind>& kind) {
  if (!kind) return "all";
  switch (*kind) {
    case PairKind::large_large:
      return "large-large";
    case PairKind::large_small:
      return "large-small";
    case PairKind::small_small:
      return "small-small";
  }
  return "all";
}

std::optional<double> read_phi_J(const std::filesystem::path& folder) {
  const auto path = folder / "result.json";
  std::ifstream stream(path);
  if (!stream) return {};
  const auto json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("phi_J") || !(json["phi_J"].is_number() || json["phi_J"].is_null()))
    throw InputError(path.string() +
                     ": phi_J is missing, or neither a number nor null; this is no result.json of furnas");
  if (json["phi_J"].is_null()) return {};
  return json["phi_J"].get<double>();
}

}  // namespace furnas
