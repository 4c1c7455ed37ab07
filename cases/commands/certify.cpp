#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>

#include "cases/commands/command.h"
#include "cases/recording.h"
#include "cases/scenario.h"
#include "engine/base/require.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/certificate_file.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string source;
  std::string out;
  std::optional<double> force_imbalance;
  std::optional<double> stress_error;
  std::optional<double> cone_excess;
  int eigenvalues = CertificateTerms{}.eigenvalues;
};

/// What the case promised; the limit of the force balance is at least the loose one.
CertificateTerms terms_of(const Case& c, std::size_t pressures_reached, const Options& options) {
  CertificateTerms terms;
  terms.springs.tangential = c.contact.tangential_stiffness;
  terms.springs.friction = c.contact.friction;
  terms.springs.arms_meet = c.contact.law != HookeHistory::name;
  terms.freedom = model_of(c, Packing{}).barostat.freedom;
  terms.pressure = c.compaction.pressure.at(std::min(pressures_reached, c.compaction.pressure.size() - 1));
  terms.least_contacts = backbone_threshold_of(c);
  const RestCriteria rest = rest_criteria_of(c);
  terms.tight_imbalance = rest.force_imbalance;
  terms.imbalance = options.force_imbalance.value_or(std::max(rest.force_imbalance, rest.loose_imbalance));
  terms.stress_error = options.stress_error.value_or(rest.stress_error);
  terms.cone_excess = options.cone_excess.value_or(terms.cone_excess);
  terms.eigenvalues = options.eigenvalues;
  return terms;
}

fs::path folder_for(const Options& options) {
  if (!options.out.empty()) {
    if (!fs::is_directory(options.out))
      throw InputError("--out " + options.out + ": no folder; allowed: a folder that exists");
    return options.out;
  }
  const fs::path source = options.source;
  return fs::is_directory(source)       ? source
         : source.parent_path().empty() ? fs::path(".")
                                        : source.parent_path();
}

}  // namespace

Command certify_command() {
  auto options = std::make_shared<Options>();
  Command command;
  command.name = "certify";
  command.does = "say whether a finished packing is jammed, from positions and histories alone";
  command.example = "furnas certify runs/first_packing";
  command.setup = [options](CLI::App& app) {
    app.add_option("DIR or FILE", options->source, "folder of a run, or a checkpoint")->required();
    app.add_option("--out", options->out,
                   "folder for certificate.json and certificate.txt; default: that of the packing");
    app.add_option(
           "--force-imbalance", options->force_imbalance,
           "largest mean |net force|/mean contact force; default: 1e-3, or more if the case asks for more")
        ->check(CLI::PositiveNumber);
    app.add_option("--stress-error", options->stress_error,
                   "largest deviation of a stress component/p_a; default: stop.stress_error of the case")
        ->check(CLI::PositiveNumber);
    app.add_option("--cone-excess", options->cone_excess,
                   "largest (|F_t| - mu F_n)/(mu mean F_n); default: 0.01")
        ->check(CLI::PositiveNumber);
    app.add_option("--eigenvalues", options->eigenvalues, "eigenvalues to show")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
  };
  command.run = [options](Console console) {
    const bool run = fs::is_directory(options->source);
    const Checkpoint checkpoint =
        run ? Checkpoints::read_newest(options->source) : read_checkpoint(options->source);
    const Case c = parse_case(checkpoint.case_text, options->source + " (checkpoint)");
    const CertificateTerms terms = terms_of(c, resting_states_of(checkpoint).size(), *options);
    const fs::path folder = folder_for(*options);
    const Certificate certificate = certify(checkpoint.packing, terms);
    write_certificate(certificate, terms, options->source, folder);
    console.out << certificate_text(certificate, terms, options->source);
    return certificate.passed() ? ExitCode::done : ExitCode::not_certified;
  };
  return command;
}

}  // namespace furnas
