#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <vector>

#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "cases/program/run/progress.h"
#include "engine/base/require.h"
#include "engine/certificate/growth.h"
#include "engine/state/validate.h"
#include "io/atomic_file.h"
#include "io/case_file.h"
#include "io/case_protocol.h"
#include "io/certificate_file.h"
#include "io/checkpoint.h"

namespace furnas {
namespace {

struct CertifyOptions {
  std::string source;
  std::optional<std::int64_t> frame;
  std::string out;
  std::string kick;
  std::optional<double> pressure, friction;  ///< of a packing that no run has made
  std::optional<double> force_imbalance;
  std::optional<double> stress_error;
  std::optional<double> cone_excess;
  int eigenvalues = CertificateTerms{}.eigenvalues;
};

/// Particles with enough contacts to be held; the backbone has about as many.
std::size_t carrying(const Packing& packing, const AnyLaw& law) {
  std::vector<int> contacts(packing.size());
  for (const Contact& c : packing.contacts) ++contacts[c.i], ++contacts[c.j];
  const int least = backbone_threshold(law);
  return static_cast<std::size_t>(
      std::count_if(contacts.begin(), contacts.end(), [&](int n) { return n >= least; }));
}

/// Announces the expected time (docs/developer/decisions/factor-instead-of-lanczos.md). With friction the
/// search for motions that grow takes longer than the eigenvalues, unless there are too many unknowns for it.
void announce(const Packing& packing, const AnyLaw& law, Console console) {
  constexpr double of_thousand = 0.1, power = 2, growth_of_thousand = 12, growth_power = 1.9,
                   noticed = 2;  // [s]
  const std::size_t particles = carrying(packing, law);
  const double thousands = static_cast<double>(particles) / 1000;
  double seconds = of_thousand * std::pow(thousands, power);
  if (has_friction(law) && 6 * particles <= static_cast<std::size_t>(most_unknowns))
    seconds += growth_of_thousand * std::pow(thousands, growth_power);
  if (seconds < noticed) return;
  console.err << "certifying " << particles
              << " particles with contacts: stiffness matrix and its eigenvalues, about "
              << duration_text(seconds) << '\n'
              << std::flush;
}

/// The limits of the case; the limit of the force balance is at least `loose_imbalance`
/// (engine/events/at_rest.h).
CertificateTerms terms_of(const PackingSource& source, const CertifyOptions& options) {
  const Case& c = *source.of_case;
  CertificateTerms terms;
  const Protocol protocol = protocol_of(c);
  terms.springs.law = law_of(protocol);
  const std::vector<Barostat> baths = baths_of(protocol, source.packing);
  const Barostat& bath = baths.at(std::min(source.reached.size(), baths.size() - 1));
  terms.cell = {.freedom = bath.freedom,
                .pressure = bath.pressure,
                .inertia = bath.inertia,
                .drag = bath.drag,
                .affine_velocity = protocol.affine_velocity,
                .legacy = bath.legacy};
  const RestCriteria& rest = protocol.rest;
  terms.tight_imbalance = rest.force_imbalance;
  terms.imbalance = options.force_imbalance.value_or(std::max(rest.force_imbalance, rest.loose_imbalance));
  terms.stress_error = options.stress_error.value_or(rest.stress_error);
  terms.cone_excess = options.cone_excess.value_or(terms.cone_excess);
  terms.eigenvalues = options.eigenvalues;
  return terms;
}

/// A packing with its pressure and friction, which follow from its run or from the options. In a file without
/// contacts the overlaps are taken as contacts, without histories.
PackingSource told_source(const CertifyOptions& options) {
  PackingSource source = packing_source(options.source, options.frame);
  if (source.of_case) {
    if (options.pressure || options.friction)
      throw InputError(
          options.source +
          ": pressure and friction follow from its case; allowed: --pressure and --friction only for a "
          "packing in a file without a case");
    return source;
  }
  if (!options.pressure)
    throw InputError(options.source +
                     ": it contains no case, so pressure and friction are unknown; allowed: the folder of a "
                     "run, one of its "
                     "checkpoints, or a packing with --pressure and, unless friction is 0, --friction");
  validate(source.packing, options.source);
  Case c;
  c.compaction.pressure = {*options.pressure};
  c.contact.friction = options.friction.value_or(0);
  source.of_case = c;
  if (source.packing.contacts.empty()) source.packing = with_overlaps_as_contacts(source.packing);
  return source;
}

/// The start of the case that --kick writes.
std::filesystem::path start_beside(std::filesystem::path file) {
  return file.replace_extension(".checkpoint");
}

/// Refuses a name for the files of --kick that cannot be used, before the long work.
void check_kick(const std::filesystem::path& file) {
  if (file.extension() != ".toml")
    throw InputError("--kick " + file.string() + ": allowed: a name that ends in .toml");
  for (const std::filesystem::path& written : {file, start_beside(file)}) refuse_existing(written);
  make_folder_of(file);
}

/// Writes the packing with its unresisted motions set going as a checkpoint, and a case that starts from it.
void write_kicked(PackingSource& source, const Certificate& certificate, double pressure,
                  const std::filesystem::path& file, Console console) {
  const std::int64_t motions = certificate.kick.motions();
  if (certificate.passed() || motions == 0) {
    console.out << fmt::format("\n--kick: {}; {} is not written\n",
                               certificate.passed() ? "the packing passes" : "no motion to set going",
                               file.string());
    return;
  }
  constexpr std::int64_t quenches = 20;
  const double speed = kick_speed(pressure);
  certificate.kick.give(source.packing, speed);
  Case c = *source.of_case;
  c.mixture = {};
  c.compaction.pressure = {pressure};
  c.start.file = start_beside(file).filename();
  c.stop.phi_error = 0;
  c.stop.final_quenches = std::max(c.stop.final_quenches, quenches);
  const std::string text = resolved_toml(c);
  write_checkpoint({source.packing, text, {}}, start_beside(file));
  write_file(file, text);
  console.out << fmt::format(
      "\n{} motion{} set going, the fastest sphere of each with {:g} d_s/time\nto follow: furnas run {}\n",
      motions, motions == 1 ? "" : "s", speed, file.string());
}

}  // namespace

Command certify_command() {
  auto options = std::make_shared<CertifyOptions>();
  Command command;
  command.name = "certify";
  command.does = "say whether a finished packing is jammed, without the forces and velocities of its run";
  command.example = "furnas certify runs/first_packing";
  command.setup = [options](CommandLine& app) {
    add_packing_source(app, options->source, options->frame);
    app.add("--out", options->out,
            "folder for certificate.json and certificate.txt; default: that of the packing");
    app.add(
        "--kick", options->kick,
        "if a part fails: write a case (.toml) and its start, the packing with the motions that no spring "
        "resists set going; its run follows them to another state of rest");
    app.add("--force-imbalance", options->force_imbalance,
            "largest mean |net force|/mean contact force; default: 1e-3, or the value in the case if that is "
            "larger")
        .above_zero();
    app.add("--stress-error", options->stress_error,
            "largest deviation of a stress component/p_a; default: stop.stress_error of the case")
        .above_zero();
    app.add("--cone-excess", options->cone_excess, "largest (|F_t| - mu F_n)/(mu mean F_n); default: 0.01")
        .above_zero();
    app.add("--pressure", options->pressure, "p_a of a packing in a file [k_n/d_s]").above_zero();
    app.add("--friction", options->friction, "mu of a packing in a file; default: 0").between(0.0, 1e30);
    app.add("--eigenvalues", options->eigenvalues, "eigenvalues to show").between(1, 100).showing_default();
  };
  command.run = [options](Console console) {
    remark_on_older_checkpoint(options->source, console.err);
    if (!options->kick.empty()) check_kick(options->kick);
    PackingSource source = told_source(*options);
    const CertificateTerms terms = terms_of(source, *options);
    const std::filesystem::path folder = folder_about(options->source, options->out);
    announce(source.packing, terms.springs.law, console);
    const Certificate certificate = certify(source.packing, terms);
    // A file stores no histories, and only for a file the pressure is an option.
    const bool histories = !options->pressure || options->friction.value_or(0) == 0;
    const CertifiedPacking certified{options->source, histories};
    write_certificate(certificate, terms, certified, folder);
    console.out << certificate_text(certificate, terms, certified);
    if (!options->kick.empty())
      write_kicked(source, certificate, terms.cell.pressure, options->kick, console);
    return certificate.passed() ? ExitCode::done : ExitCode::not_certified;
  };
  return command;
}

}  // namespace furnas
