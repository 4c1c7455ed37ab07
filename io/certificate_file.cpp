#include "io/certificate_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/atomic_file.h"
#include "io/json_text.h"

namespace furnas {
namespace {

using Json = nlohmann::ordered_json;  // writes NaN and infinity as null

const char* word(Proves proves) {
  switch (proves) {
    case Proves::sufficient:
      return "sufficient to first order";
    case Proves::neither:
      return "neither necessary nor sufficient";
    case Proves::necessary:
      break;
  }
  return "necessary only";
}

constexpr const char* rule = "every overlap counts";

std::string failed_parts(const Certificate& c) {
  std::string failed;
  for (const Part& part : c.parts)
    if (!part.passed()) failed += (failed.empty() ? "" : ", ") + part.name;
  return failed;
}

/// Whether a part failed that a jammed packing may fail.
bool decides_nothing(const Certificate& c) {
  return std::any_of(c.parts.begin(), c.parts.end(),
                     [](const Part& part) { return part.proves == Proves::neither && !part.passed(); });
}

/// What all parts together prove, and what they do not prove.
std::string conclusion(const Certificate& c, const CertifiedPacking& of) {
  if (!c.passed() && !of.histories)
    return fmt::format(
        "Not certified: {} failed. The file has no tangential histories, so the tangential forces are taken "
        "to be zero. With friction, such forces cannot balance, so this result says nothing about the "
        "packing. Certify the "
        "folder of its run, or a checkpoint.",
        failed_parts(c));
  if (!c.passed())
    return fmt::format(
        "Not certified: {} failed, and a jammed packing passes every part{}. The parts that passed prove "
        "nothing on their own.",
        failed_parts(c), decides_nothing(c) ? " that is necessary" : "");
  const bool stable = std::any_of(c.parts.begin(), c.parts.end(),
                                  [](const Part& part) { return part.proves == Proves::sufficient; });
  if (stable)
    return "Forces balance at the applied pressure within the limits below. Proven, to first order: every "
           "small "
           "motion of backbone and cell costs energy. Not proven: what large motions, long times or a larger "
           "cell would do. Rattlers are free to move, and no part examines them.";
  return "Proven: the packing meets every tested condition that a jammed packing must meet. Not proven: that "
         "every small motion costs energy, because contacts slide or an eigenvalue is in doubt (part "
         "\"stability\"); large motions, long times and larger cells were not examined.";
}

Json json_of(const Finding& f) {
  Json json = {{"name", f.name}, {"value", f.value}};
  if (f.bound == Finding::Bound::none) return json;
  json[f.bound == Finding::Bound::at_most ? "at_most" : "at_least"] = f.limit;
  json["holds"] = f.holds();
  return json;
}

Json json_of(const Part& part) {
  Json findings = Json::array();
  for (const Finding& f : part.findings) findings.push_back(json_of(f));
  Json json = {{"name", part.name},
               {"passed", part.passed()},
               {"proves", word(part.proves)},
               {"asks", part.asks},
               {"findings", findings}};
  if (!part.note.empty()) json["note"] = part.note;
  return json;
}

Json json_of(const Certificate& c, const CertificateTerms& terms, const CertifiedPacking& of) {
  Json parts = Json::array();
  for (const Part& part : c.parts) parts.push_back(json_of(part));
  Json failed = Json::array();
  for (const Part& part : c.parts)
    if (!part.passed()) failed.push_back(part.name);
  Json eigenvalues = Json::array();
  for (const double x : c.eigenvalues) eigenvalues.push_back(x);
  return {{"of", of.name},
          {"conclusion", conclusion(c, of)},
          {"passed", c.passed()},
          {"failed", failed},
          {"force_balance", to_string(c.balance)},
          {"particles", c.particles},
          {"backbone", c.backbone},
          {"backbone_rule", rule},
          {"backbone_of_live_contacts", c.live_backbone},
          {"contacts", c.contacts},
          {"contacts_not_in_the_list", c.unlisted},
          {"listed_contacts_that_are_open", c.open},
          {"applied_pressure", terms.cell.pressure},
          {"friction", terms.springs.friction()},
          {"least_contacts", c.least_contacts},
          {"bulk_modulus", c.bulk_modulus},
          {"shear_modulus", c.shear_modulus},
          {"eigenvalues", eigenvalues},
          {"growth_rate", c.growth_rate},
          {"parts", parts}};
}

std::string line_of(const Finding& f) {
  const std::string limit =
      f.bound == Finding::Bound::none
          ? ""
          : fmt::format("   {} {:g}{}", f.bound == Finding::Bound::at_most ? "<=" : ">=", f.limit,
                        f.holds() ? "" : "   FAILS");
  const std::string value = std::isfinite(f.value) ? fmt::format("{:.6g}", f.value) : "not known";
  return fmt::format("    {:<62} {:>12}{}\n", f.name, value, limit);
}

}  // namespace

std::string certificate_text(const Certificate& c, const CertificateTerms& terms,
                             const CertifiedPacking& of) {
  std::string text = fmt::format("Certificate of {}\n\n{}\n\n", of.name, conclusion(c, of));
  text += fmt::format(
      "{} particles, {} of them in the backbone with {} contacts ({}); by the rule of a run (live contacts "
      "only) {}.\n",
      c.particles, c.backbone, c.contacts, rule, c.live_backbone);
  text += fmt::format("Friction {:g}, p_a {:g}. ", terms.springs.friction(), terms.cell.pressure);
  text +=
      of.histories
          ? fmt::format(
                "Recomputed from positions, radii, masses, cell and tangential histories, without forces and "
                "velocities; the run's list lacks {} contacts and has {} that are open.\n\n",
                c.unlisted, c.open)
          : "Recomputed from positions, radii and cell alone; the file has no tangential histories.\n\n";
  for (const Part& part : c.parts) {
    text += fmt::format("{}  {} ({})\n  {}\n", part.passed() ? "passed" : "FAILED", part.name,
                        part.proves == Proves::necessary ? "necessary" : word(part.proves), part.asks);
    for (const Finding& f : part.findings) text += line_of(f);
    if (!part.note.empty()) text += fmt::format("    {}\n", part.note);
    text += '\n';
  }
  text += c.passed() ? fmt::format("jammed: every part passed, force balance {}\n", to_string(c.balance))
                     : fmt::format("not certified: {} failed\n", failed_parts(c));
  return text;
}

void write_certificate(const Certificate& certificate, const CertificateTerms& terms,
                       const CertifiedPacking& of, const std::filesystem::path& folder) {
  write_file(folder / "certificate.json", json_text(json_of(certificate, terms, of)));
  write_file(folder / "certificate.txt", certificate_text(certificate, terms, of));
}

}  // namespace furnas
