#include "io/certificate_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/atomic_file.h"

namespace furnas {
namespace {

using Json = nlohmann::ordered_json;  // writes NaN and infinity as null

const char* word(Proves proves) {
  return proves == Proves::necessary ? "necessary only" : "sufficient to first order";
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

Json json_of(const Certificate& c, const CertificateTerms& terms, const std::string& of) {
  Json parts = Json::array();
  for (const Part& part : c.parts) parts.push_back(json_of(part));
  Json failed = Json::array();
  for (const Part& part : c.parts)
    if (!part.passed()) failed.push_back(part.name);
  Json eigenvalues = Json::array();
  for (const double x : c.eigenvalues) eigenvalues.push_back(x);
  return {{"of", of},
          {"passed", c.passed()},
          {"failed", failed},
          {"force_balance", to_string(c.balance)},
          {"particles", c.particles},
          {"backbone", c.backbone},
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
  return fmt::format("    {:<62} {:>12.6g}{}\n", f.name, f.value, limit);
}

}  // namespace

std::string certificate_text(const Certificate& c, const CertificateTerms& terms, const std::string& of) {
  std::string text = fmt::format("Certificate of {}\n\n", of);
  text += fmt::format("{} particles, {} of them in the backbone with {} contacts; friction {:g}, p_a {:g}.\n",
                      c.particles, c.backbone, c.contacts, terms.springs.friction(), terms.cell.pressure);
  text += "Recomputed from positions, radii, cell and tangential histories alone";
  text += fmt::format("; the run's list lacks {} contacts and has {} that are open.\n\n", c.unlisted, c.open);
  for (const Part& part : c.parts) {
    text += fmt::format("{}  {} ({})\n  {}\n", part.passed() ? "passed" : "FAILED", part.name,
                        word(part.proves), part.asks);
    for (const Finding& f : part.findings) text += line_of(f);
    if (!part.note.empty()) text += fmt::format("    {}\n", part.note);
    text += '\n';
  }
  text +=
      "A part that is necessary only must pass for a jammed packing, but a packing that is not jammed may "
      "pass "
      "it\ntoo. Stability, with force balance and stress, is sufficient to first order: against any small "
      "motion, with\nfriction as it stands; sliding contacts, large motions and time are beyond it "
      "(docs/theory/certificate.md).\n\n";
  std::string failed;
  for (const Part& part : c.parts)
    if (!part.passed()) failed += (failed.empty() ? "" : ", ") + part.name;
  text += c.passed() ? fmt::format("jammed: every part passed, force balance {}\n", to_string(c.balance))
                     : fmt::format("not certified: {} failed\n", failed);
  return text;
}

void write_certificate(const Certificate& certificate, const CertificateTerms& terms, const std::string& of,
                       const std::filesystem::path& folder) {
  write_file(folder / "certificate.json", json_of(certificate, terms, of).dump(2) + "\n");
  write_file(folder / "certificate.txt", certificate_text(certificate, terms, of));
}

}  // namespace furnas
