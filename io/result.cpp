#include "io/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/atomic_file.h"

namespace furnas {
namespace {

using Json = nlohmann::ordered_json;  // writes NaN and infinity as null

/// A count of one species; null where there are none to tell apart.
Json of_species(const Result& r, std::int64_t count) { return r.has_species() ? Json(count) : Json(nullptr); }

Json rattlers(const Result& r) {
  Json all = Json::array();
  for (const RattlerCount& c : r.measures.rattlers) {
    const auto share = [&](std::int64_t part, std::int64_t whole) {
      return whole > 0 && r.has_species() ? Json(static_cast<double>(part) / static_cast<double>(whole))
                                          : Json(nullptr);
    };
    all.push_back({{"least_contacts", c.least_contacts},
                   {"large", of_species(r, c.large)},
                   {"small", of_species(r, c.small)},
                   {"large_share", share(c.large, r.large)},
                   {"small_share", share(c.small, r.small)},
                   {"backbone", c.backbone},
                   {"contacts", c.contacts},
                   {"coordination", c.coordination}});
  }
  return all;
}

Json reached(const Result& r) {
  Json all = Json::array();
  for (const RestingState& s : r.reached)
    all.push_back({{"pressure", s.pressure}, {"phi_J", s.phi}, {"step", s.step}});
  return all;
}

/// Which limit of the balance of forces was kept; the paper's criterion asks for none.
const char* balance(const Result& r, const Case& c) {
  if (r.verdict != Verdict::jammed || c.stop.criterion == "paper") return nullptr;
  return r.rest.loosely ? "loose" : "tight";
}

/// The balance of the energy: `relative_gap` is what it misses, over what went through.
Json energy(const Measures& m) {
  const Ledger& l = m.ledger;
  return {{"kinetic", m.energy.kinetic},
          {"normal", m.energy.normal},
          {"tangential", m.energy.tangential},
          {"initial", l.initial},
          {"cell_work", l.cell_work},
          {"normal_damping", l.losses.normal_damping},
          {"tangential_damping", l.losses.tangential_damping},
          {"sliding", l.losses.sliding},
          {"opening", l.losses.opening},
          {"quenched", l.quenched},
          {"relative_gap", l.relative_gap(m.energy.total())}};
}

Json cell(const Triangle& h) {
  return {{"lx", h.xx}, {"ly", h.yy}, {"lz", h.zz}, {"xy", h.xy}, {"xz", h.xz}, {"yz", h.yz}};
}

}  // namespace

double Result::thickness() const {
  const Vec3<double> h = heights(measures.cell.edges);
  return std::min({h.x, h.y, h.z}) / largest_diameter;
}

std::optional<double> Result::phi_J() const {
  if (verdict != Verdict::jammed) return {};
  return measures.phi;
}

const char* remark_on_thickness(double diameters) {
  return diameters < 3 ? ": too thin to stand for a large packing" : "";
}

void write_result(const Result& r, const Case& c, const std::filesystem::path& path) {
  const Measures& m = r.measures;
  const auto phi_j = r.phi_J();
  const char* const found_balance = balance(r, c);
  const auto& s = m.stress;
  const auto& backbone = m.backbone();
  Json json = {
      {"verdict", to_string(r.verdict)},
      {"reason", r.reason},
      {"criterion", c.stop.criterion},
      {"version", r.version},
      {"phi_J", phi_j ? Json(*phi_j) : Json(nullptr)},
      {"phi", m.phi},
      {"phi_bound", r.verdict == Verdict::jammed ? Json(nullptr) : Json(r.phi_bound)},
      {"state_hash", fmt::format("{:016x}", r.state_hash)},
      {"force_balance", found_balance ? Json(found_balance) : Json(nullptr)},
      {"force_imbalance", backbone.backbone > 0 ? Json(m.force_imbalance) : Json(nullptr)},
      {"stress_error", r.rest.stress_error},
      {"strain_drift_in_2000_t_c", r.rest.strain_drift},
      {"kinetic_energy_per_particle", m.kinetic_energy},
      {"backbone_kinetic_energy_per_particle",
       backbone.backbone > 0 ? Json(m.backbone_kinetic_energy) : Json(nullptr)},
      {"pressure", m.pressure},
      {"applied_pressure", c.compaction.cell == "fixed" ? Json(nullptr) : Json(r.pressure)},
      {"stress", {{"xx", s[0]}, {"yy", s[1]}, {"zz", s[2]}, {"xy", s[3]}, {"xz", s[4]}, {"yz", s[5]}}},
      {"Z", m.coordination},
      {"Z_backbone", backbone.coordination},
      {"contacts", m.contacts},
      {"backbone_threshold", m.backbone_threshold},
      {"rattlers", rattlers(r)},
      {"quenches", r.quenches},
      {"minimizer_evaluations", r.evaluations},
      {"energy", energy(m)},
      {"sliding_share", m.sliding_share},
      {"largest_overlap", m.largest_overlap},
      {"mean_force", m.mean_force},
      {"resting_states", reached(r)},
      {"particles", r.large + r.small},
      {"large", of_species(r, r.large)},
      {"small", of_species(r, r.small)},
      {"polydisperse", r.polydisperse},
      {"cell", cell(m.cell.edges)},
      {"thickness_in_largest_diameters", r.thickness()},
      {"law", c.contact.friction > 0 ? c.contact.law : c.contact.law + " without friction"},
      {"friction", c.contact.friction},
      {"precision", c.compute.precision},
      {"time_step", r.time_step},
      {"inertia", r.inertia},
      {"seed", c.mixture.seed},
      {"steps", m.step},
      {"time", m.time},
      {"flips", r.flips},
      {"lists_built", m.rebuilds},
      {"threads", r.threads},
      {"wall_seconds", r.wall_seconds},
      {"cpu_seconds", r.cpu_seconds},
      {"million_particle_steps_per_second",
       r.wall_seconds > 0 ? Json(static_cast<double>(r.steps_here) * static_cast<double>(r.large + r.small) /
                                 r.wall_seconds / 1e6)
                          : Json(nullptr)},
  };
  write_file(path, json.dump(2) + "\n");
}

}  // namespace furnas
