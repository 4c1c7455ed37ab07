#include "io/result_fields.h"

#include <fmt/format.h>

namespace furnas {
namespace {

using Json = nlohmann::ordered_json;

/// A count of one species; null where large and small spheres are not distinguished.
Json of_species(const Result& r, std::int64_t count) { return r.has_species() ? Json(count) : Json(nullptr); }

Json share(const Result& r, std::int64_t part, std::int64_t whole) {
  if (whole == 0 || !r.has_species()) return nullptr;
  return static_cast<double>(part) / static_cast<double>(whole);
}

/// A measure of the backbone; null without a backbone.
Json of_backbone(const Result& r, double value) {
  return r.measures.backbone().backbone > 0 ? Json(value) : Json(nullptr);
}

/// Which limit of the force balance the packing meets; the paper's criterion has no such limit.
Json force_balance(const Result& r, const Case& c) {
  if (r.verdict != Verdict::jammed || c.stop.criterion == "paper") return nullptr;
  return r.rest.loosely ? "loose" : "tight";
}

template <class Fields, class Row, class... Rest>
Json entry(const Fields& fields, const Row& row, const Rest&... rest) {
  Json json;
  for (const auto& field : fields) json[std::string(field.about.name)] = field.value(row, rest...);
  return json;
}

Json rattlers(const Result& r, const Case&) {
  Json all = Json::array();
  for (const RattlerCount& count : r.measures.rattlers) all.push_back(entry(rattler_fields(), count, r));
  return all;
}

Json resting_states(const Result& r, const Case&) {
  Json all = Json::array();
  for (const RestingState& state : r.reached) all.push_back(entry(resting_fields(), state, r));
  return all;
}

Json pace(const Result& r, const Case&) {
  const std::optional<double> pace = r.pace();
  return pace ? Json(*pace) : Json(nullptr);
}

#define FURNAS_FIELD(expression) \
  []([[maybe_unused]] const Result& r, [[maybe_unused]] const Case& c) -> Json { return expression; }
#define FURNAS_MEASURE(expression)           \
  [](const Result& r, const Case&) -> Json { \
    const Measures& m = r.measures;          \
    return expression;                       \
  }

// clang-format off
const ResultField fields[] = {
    {{"verdict", "", "run", "jammed, settled, budget, diverged or interrupted"}, FURNAS_FIELD(to_string(r.verdict))},
    {{"reason", "", "run", "why the run ended with this verdict, in a sentence"}, FURNAS_FIELD(r.reason)},
    {{"criterion", "", "run", "stop.criterion: what counts as rest"}, FURNAS_FIELD(c.stop.criterion)},
    {{"version", "", "run", "version of furnas; another version may give other bits"}, FURNAS_FIELD(r.version)},
    {{"phi_J", "", "packing", "packing fraction at jamming; null unless the verdict is jammed"}, FURNAS_FIELD(r.phi_J() ? Json(*r.phi_J()) : Json(nullptr))},
    {{"phi", "", "packing", "packing fraction: volume of the spheres (overlaps counted twice) over that of the cell"}, FURNAS_MEASURE(m.phi)},
    {{"phi_bound", "", "packing", "bound on the further change of phi; null for a jammed packing, and where it is not known"}, FURNAS_FIELD(r.verdict == Verdict::jammed ? Json(nullptr) : Json(r.phi_bound))},
    {{"state_hash", "", "packing", "checksum of the whole state; states with equal bits have equal hashes"}, FURNAS_FIELD(fmt::format("{:016x}", r.state_hash))},
    {{"force_balance", "", "run", "of a jammed packing; tight: force_imbalance is below stop.force_imbalance; loose: it was below 1e-3 for ten windows"}, force_balance},
    {{"force_imbalance", "", "mean over the backbone", "size of the net force on a particle over the mean force of all contacts"}, FURNAS_FIELD(of_backbone(r, r.measures.force_imbalance))},
    {{"stress_error", "", "largest component", "|P_aa - p_a|/p_a or |P_ab|/p_a, of the components to which the cell can respond"}, FURNAS_FIELD(r.rest.stress_error)},
    {{"strain_drift_in_2000_t_c", "", "packing", "Frobenius norm of the strain of the cell, scaled to 2000 collision times: the smaller of the values over the last window and over the last ten"}, FURNAS_FIELD(r.rest.strain_drift)},
    {{"kinetic_energy_per_particle", "k_n d_s^2", "per particle", "of the peculiar motion and spin of all spheres, rattlers included"}, FURNAS_MEASURE(m.kinetic_energy)},
    {{"backbone_kinetic_energy_per_particle", "k_n d_s^2", "per backbone particle", "the same for the backbone"}, FURNAS_FIELD(of_backbone(r, r.measures.backbone_kinetic_energy))},
    {{"pressure", "k_n/d_s", "packing", "trace(P)/3 of the measured stress, positive in compression"}, FURNAS_MEASURE(m.pressure)},
    {{"applied_pressure", "k_n/d_s", "bath", "p_a at the end; null in a fixed cell"}, FURNAS_FIELD(c.compaction.cell == "fixed" ? Json(nullptr) : Json(r.pressure))},
    {{"stress.xx", "k_n/d_s", "packing", "symmetric part of P = (sum m v v + sum branch force)/volume, over particles and contacts, positive in compression"}, FURNAS_MEASURE(m.stress[0])},
    {{"stress.yy", "k_n/d_s", "packing", "the same"}, FURNAS_MEASURE(m.stress[1])},
    {{"stress.zz", "k_n/d_s", "packing", "the same"}, FURNAS_MEASURE(m.stress[2])},
    {{"stress.xy", "k_n/d_s", "packing", "the same"}, FURNAS_MEASURE(m.stress[3])},
    {{"stress.xz", "k_n/d_s", "packing", "the same"}, FURNAS_MEASURE(m.stress[4])},
    {{"stress.yz", "k_n/d_s", "packing", "the same"}, FURNAS_MEASURE(m.stress[5])},
    {{"Z", "", "per particle", "coordination: 2 contacts/particles, rattlers included"}, FURNAS_MEASURE(m.coordination)},
    {{"Z_backbone", "", "per backbone particle", "2 contacts among backbone particles/backbone particles"}, FURNAS_MEASURE(m.backbone().coordination)},
    {{"contacts", "", "total", "pairs that overlap, live or not; a pair that touches across two faces counts twice"}, FURNAS_MEASURE(m.contacts)},
    {{"backbone_threshold", "", "run", "least number of live contacts of a backbone particle: 2 with friction, 4 without; a contact is live if its normal force is above 1 % of the mean of its kind"}, FURNAS_MEASURE(m.backbone_threshold)},
    {{"rattlers", "", "list", "counts of rattlers for the thresholds of 2, 3 and 4 live contacts"}, rattlers},
    {{"quenches", "", "total", "number of times that all motion was set to zero"}, FURNAS_FIELD(r.quenches)},
    {{"minimizer_evaluations", "", "total", "number of times that the minimizer computed all forces"}, FURNAS_FIELD(r.evaluations)},
    {{"energy.kinetic", "k_n d_s^2", "total", "of the peculiar motion and spin, at the end"}, FURNAS_MEASURE(m.energy.kinetic)},
    {{"energy.normal", "k_n d_s^2", "total", "stored in overlaps, at the end"}, FURNAS_MEASURE(m.energy.normal)},
    {{"energy.tangential", "k_n d_s^2", "total", "stored in tangential springs, at the end"}, FURNAS_MEASURE(m.energy.tangential)},
    {{"energy.initial", "k_n d_s^2", "total", "at the start"}, FURNAS_MEASURE(m.ledger.initial)},
    {{"energy.cell_work", "k_n d_s^2", "total since the start", "done by the moving cell on the particles, positive when it compresses them"}, FURNAS_MEASURE(m.ledger.cell_work)},
    {{"energy.normal_damping", "k_n d_s^2", "total since the start", "taken out by normal damping"}, FURNAS_MEASURE(m.ledger.losses.normal_damping)},
    {{"energy.tangential_damping", "k_n d_s^2", "total since the start", "taken out by tangential damping"}, FURNAS_MEASURE(m.ledger.losses.tangential_damping)},
    {{"energy.sliding", "k_n d_s^2", "total since the start", "taken out by contacts at the Coulomb limit"}, FURNAS_MEASURE(m.ledger.losses.sliding)},
    {{"energy.opening", "k_n d_s^2", "total since the start", "left in the tangential springs of contacts that opened"}, FURNAS_MEASURE(m.ledger.losses.opening)},
    {{"energy.quenched", "k_n d_s^2", "total since the start", "kinetic energy removed when all motion is set to zero, and energy removed by the minimizer"}, FURNAS_MEASURE(m.ledger.quenched)},
    {{"energy.relative_gap", "", "total", "energy gap of the balance over the energy that went through it; 0 if nothing is missing"}, FURNAS_MEASURE(m.ledger.relative_gap(m.energy.total()))},
    {{"sliding_share", "", "share of the contacts", "those at the Coulomb limit"}, FURNAS_MEASURE(m.sliding_share)},
    {{"largest_overlap", "", "largest of the contacts", "overlap over the smaller radius of the pair"}, FURNAS_MEASURE(m.largest_overlap)},
    {{"mean_force", "k_n d_s", "mean over the contacts", "size of the force of a contact, normal and tangential"}, FURNAS_MEASURE(m.mean_force)},
    {{"resting_states", "", "list", "each pressure at which the packing came to rest or settled"}, resting_states},
    {{"particles", "", "total", "spheres"}, FURNAS_FIELD(r.large + r.small)},
    {{"large", "", "total", "large spheres; null in a polydisperse packing, as is every count of a species"}, FURNAS_FIELD(of_species(r, r.large))},
    {{"small", "", "total", "small spheres; null in a polydisperse packing"}, FURNAS_FIELD(of_species(r, r.small))},
    {{"polydisperse", "", "packing", "true if spheres of one species differ in size"}, FURNAS_FIELD(r.polydisperse)},
    {{"diameters.sizes", "", "total", "number of different diameters; two that differ by less than a millionth count as one"}, FURNAS_FIELD(r.sizes.count)},
    {{"diameters.smallest", "d_s", "packing", "diameter of the smallest sphere"}, FURNAS_FIELD(r.sizes.smallest)},
    {{"diameters.mean", "d_s", "mean over the spheres", "diameter"}, FURNAS_FIELD(r.mean_diameter)},
    {{"diameters.largest", "d_s", "packing", "diameter of the largest sphere"}, FURNAS_FIELD(r.sizes.largest)},
    {{"diameters.listed_unit", "that of mixture.diameters", "run", "1 d_s in the unit of the list mixture.diameters; a length times this number is in that unit; null without a list"}, FURNAS_FIELD(r.listed_unit ? Json(*r.listed_unit) : Json(nullptr))},
    {{"cell.lx", "d_s", "cell", "edges of the cell are (lx, 0, 0), (xy, ly, 0), (xz, yz, lz)"}, FURNAS_MEASURE(m.cell.edges.xx)},
    {{"cell.ly", "d_s", "cell", "the same"}, FURNAS_MEASURE(m.cell.edges.yy)},
    {{"cell.lz", "d_s", "cell", "the same"}, FURNAS_MEASURE(m.cell.edges.zz)},
    {{"cell.xy", "d_s", "cell", "the same"}, FURNAS_MEASURE(m.cell.edges.xy)},
    {{"cell.xz", "d_s", "cell", "the same"}, FURNAS_MEASURE(m.cell.edges.xz)},
    {{"cell.yz", "d_s", "cell", "the same"}, FURNAS_MEASURE(m.cell.edges.yz)},
    {{"thickness_in_largest_diameters", "", "cell", "least distance between opposite faces over the largest diameter; below 2.5 the cell is too thin to represent a large packing"}, FURNAS_FIELD(r.thickness())},
    {{"law", "", "run", "contact law"}, FURNAS_FIELD(c.contact.friction > 0 ? c.contact.law : c.contact.law + " without friction")},
    {{"friction", "", "run", "Coulomb's coefficient mu"}, FURNAS_FIELD(c.contact.friction)},
    {{"precision", "", "run", "compute.precision"}, FURNAS_FIELD(c.compute.precision)},
    {{"time_step", "(rho d_s^3/k_n)^(1/2)", "run", "dt"}, FURNAS_FIELD(r.time_step)},
    {{"inertia", "rho d_s^5", "cell", "inertia W of the cell"}, FURNAS_FIELD(r.inertia)},
    {{"seed", "", "run", "mixture.seed"}, FURNAS_FIELD(c.mixture.seed)},
    {{"steps", "", "total", "time steps from the start of the run"}, FURNAS_MEASURE(m.step)},
    {{"time", "(rho d_s^3/k_n)^(1/2)", "run", "simulated time"}, FURNAS_MEASURE(m.time)},
    {{"flips", "", "total", "number of times that tilted edges of the cell were replaced by shorter ones of the same lattice"}, FURNAS_FIELD(r.flips)},
    {{"lists_built", "", "total", "neighbour lists built since the run began"}, FURNAS_MEASURE(m.rebuilds)},
    {{"threads", "", "run", "of the last process"}, FURNAS_FIELD(r.threads)},
    {{"wall_seconds", "s", "total", "wall-clock time of all processes of the run"}, FURNAS_FIELD(r.wall_seconds)},
    {{"cpu_seconds", "s", "total", "CPU time of all threads of these processes; null if one of them did not record it"}, FURNAS_FIELD(r.cpu_seconds)},
    {{"million_particle_steps_per_second", "10^6/s", "mean", "speed: particles times steps over wall-clock time"}, pace},
};

const RattlerField rattler_table[] = {
    {{"least_contacts", "", "entry", "threshold z_min: particles with fewer live contacts are removed repeatedly, until all that remain have enough"}, [](const RattlerCount& n, const Result&) -> Json { return n.least_contacts; }},
    {{"applies", "", "entry", "true for the threshold of the run, which defines the backbone of Z_backbone and force_imbalance"}, [](const RattlerCount& n, const Result& r) -> Json { return n.least_contacts == r.measures.backbone_threshold; }},
    {{"large", "", "total", "large spheres that are rattlers"}, [](const RattlerCount& n, const Result& r) { return of_species(r, n.large); }},
    {{"small", "", "total", "small spheres that are rattlers"}, [](const RattlerCount& n, const Result& r) { return of_species(r, n.small); }},
    {{"large_share", "", "share of the large spheres", "rattlers among these spheres; null without spheres of this species"}, [](const RattlerCount& n, const Result& r) { return share(r, n.large, r.large); }},
    {{"small_share", "", "share of the small spheres", "rattlers among these spheres; null without spheres of this species"}, [](const RattlerCount& n, const Result& r) { return share(r, n.small, r.small); }},
    {{"backbone", "", "total", "spheres that are no rattlers, N_0"}, [](const RattlerCount& n, const Result&) -> Json { return n.backbone; }},
    {{"contacts", "", "total", "contacts among them, N_c"}, [](const RattlerCount& n, const Result&) -> Json { return n.contacts; }},
    {{"coordination", "", "per backbone particle", "2 N_c/N_0; 0 without a backbone"}, [](const RattlerCount& n, const Result&) -> Json { return n.coordination; }},
};

const RestingField resting_table[] = {
    {{"pressure", "k_n/d_s", "bath", "p_a"}, [](const RestingState& s, const Result&) -> Json { return s.pressure; }},
    {{"phi_J", "", "packing", "packing fraction at rest under this pressure; null if the packing settled"}, [](const RestingState& s, const Result&) -> Json { return s.phi_bound == 0 ? Json(s.phi) : Json(); }},
    {{"phi", "", "packing", "packing fraction under this pressure, at rest or settled"}, [](const RestingState& s, const Result&) -> Json { return s.phi; }},
    {{"phi_bound", "", "packing", "bound on the further change of phi of a packing that settled; null at rest"}, [](const RestingState& s, const Result&) -> Json { return s.phi_bound == 0 ? Json() : Json(s.phi_bound); }},
    {{"step", "", "run", "time step at which the packing was at rest, or had settled"}, [](const RestingState& s, const Result&) -> Json { return s.step; }},
    {{"Z_backbone", "", "per backbone particle", "coordination of the backbone then"}, [](const RestingState& s, const Result&) -> Json { return s.Z_backbone; }},
    {{"large_rattlers", "", "total", "large spheres that were rattlers, by the threshold that applies"}, [](const RestingState& s, const Result& r) { return of_species(r, s.large_rattlers); }},
    {{"small_rattlers", "", "total", "small spheres that were rattlers, by the threshold that applies"}, [](const RestingState& s, const Result& r) { return of_species(r, s.small_rattlers); }},
};
// clang-format on

}  // namespace

std::span<const ResultField> result_fields() { return fields; }
std::span<const RattlerField> rattler_fields() { return rattler_table; }
std::span<const RestingField> resting_fields() { return resting_table; }

}  // namespace furnas
