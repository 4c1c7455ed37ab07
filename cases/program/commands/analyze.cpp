#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>

#include "cases/program/chart_files.h"
#include "cases/program/commands/command.h"
#include "cases/program/packing_source.h"
#include "engine/base/require.h"
#include "engine/state/validate.h"
#include "io/analysis_files.h"
#include "io/atomic_file.h"
#include "io/case_protocol.h"
#include "viz/analysis_charts.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

struct AnalyzeOptions {
  std::string source;
  std::optional<std::int64_t> frame;
  std::string out;
  std::optional<double> friction;
  std::optional<int> backbone;
  AnalysisOptions analysis;
  bool no_pictures = false;
};

/// `about`: the case of the packing, if it is known.
AnalysisOptions analysis_options(const AnalyzeOptions& options, const std::optional<Case>& about) {
  AnalysisOptions analysis = options.analysis;
  const double of_case = about ? about->contact.friction : 0;
  analysis.friction = options.friction.value_or(of_case);
  Case c;
  c.contact.friction = analysis.friction;
  analysis.backbone_threshold = options.backbone.value_or(backbone_threshold_of(c));
  return analysis;
}

AnalysisRecord analyze_source(const AnalyzeOptions& options) {
  PackingSource source = packing_source(options.source, options.frame);
  validate(source.packing, options.source);
  AnalysisRecord record;
  record.source = options.source;
  record.step = source.packing.step;
  if (source.packing.contacts.empty()) {
    source.packing = with_overlaps_as_contacts(source.packing);
    record.contacts_are_overlaps = true;
  }
  const auto about = case_about(source, options.source);
  AnalysisOptions analysis = analysis_options(options, about);
  record.friction_is_known = about.has_value();
  // Overlaps contain no information about tangential forces.
  if (record.contacts_are_overlaps) analysis.friction = 0;
  record.analysis = analyze(source.packing, analysis);
  if (fs::is_directory(options.source)) record.phi_J = read_phi_J(options.source);
  return record;
}

/// Names of the files that were written.
std::vector<std::string> write_files(const AnalysisRecord& record, const fs::path& folder, bool pictures,
                                     Console console) {
  std::vector<std::string> written;
  for (const AnalysisFile& file : analysis_files()) {
    const std::string content = file.content(record);
    if (content.empty()) continue;
    write_file(folder / file.name, content);
    written.emplace_back(file.name);
  }
  if (!pictures) return written;
  for (const auto& [name, chart] : analysis_charts(record.analysis)) {
    const std::vector<std::string> files = write_chart(chart, folder, name, console);
    written.insert(written.end(), files.begin(), files.end());
  }
  return written;
}

std::string contacts_text(const Coordination& c) {
  std::string text;
  const auto add = [&](Species species, std::int64_t count, const char* name) {
    if (count == 0) return;
    text += fmt::format("{}a {} sphere touches {:.3f} large and {:.3f} small ones", text.empty() ? "" : "; ",
                        name, c.of(species, Species::large), c.of(species, Species::small));
  };
  add(Species::large, c.large, "large");
  add(Species::small, c.small, "small");
  return text;
}

std::string rattlers_text(const RattlerCount& out, const Analysis& a) {
  if (!a.has_species()) return fmt::format("{} of {}", out.large + out.small, a.large + a.small);
  return fmt::format("{} of {} large, {} of {} small", out.large, a.large, out.small, a.small);
}

std::string network_text(const Analysis& a) {
  const NetworkAnalysis& n = *a.network;
  const Coordination &all = n.coordination, &backbone = n.backbone_coordination;
  const ContactAnalysis& together = n.backbone.front();
  std::string text =
      fmt::format("Z         {:.3f} with rattlers, {:.3f} in the backbone of {} particles and {} contacts\n",
                  all.mean(), backbone.mean(), backbone.particles(), backbone.all_contacts());
  if (a.small > 0 && a.has_species()) {
    text += fmt::format("contacts  {}\n", contacts_text(all));
    if (backbone.particles() > 0)
      text += fmt::format("          in the backbone: {}\n", contacts_text(backbone));
  }
  text +=
      fmt::format("rattlers  {} (fewer than {} live contacts)\n",
                  rattlers_text({.large = a.large - backbone.large, .small = a.small - backbone.small}, a),
                  a.backbone_threshold);
  text += fmt::format("forces    mean normal force of the backbone {:.4g}, largest {:.3g} times the mean\n",
                      together.normal.mean,
                      together.normal.mean > 0 ? together.normal.largest / together.normal.mean : 0);
  if (together.mobilisation) {
    text += fmt::format(
        "sliding   {:.2f} % of the contacts of the backbone; mobilisation {:.3f} on average (friction {})\n",
        100 * together.mobilisation->sliding_share(), together.mobilisation->mean, a.friction);
    if (together.mobilisation->beyond > 0)
      text += fmt::format(
          "          {} contacts exceed this friction, so the packing was made with another friction\n",
          together.mobilisation->beyond);
  }
  text += fmt::format(
      "fabric    anisotropy {:.4f} in the backbone ({:.4f} expected by chance), {:.4f} of all contacts\n",
      together.fabric.anisotropy(), together.fabric.anisotropy_by_chance(), n.fabric.front().anisotropy());
  return text;
}

std::string summary(const AnalysisRecord& record) {
  const Analysis& a = record.analysis;
  std::string text = fmt::format("step      {}\n", record.step);
  text += fmt::format("phi       {:.5f}{}; {}\n", a.phi, record.phi_J ? " (phi_J: jammed)" : "",
                      a.has_species() ? fmt::format("{} large, {} small", a.large, a.small)
                                      : fmt::format("{} spheres", a.large + a.small));
  if (a.polydisperse)
    text += fmt::format(
        "sizes     {} from {:.6g} to {:.6g}: polydisperse, so that there are no f_s, phi_L, phi_S\n",
        a.sizes.count, a.sizes.smallest, a.sizes.largest);
  if (a.mixture && a.small > 0)
    text += fmt::format("furnas    f_s {:.4f}, phi_L {:.5f}, phi_S {:.5f}\n", a.mixture->small_fraction,
                        a.mixture->phi_large, a.mixture->phi_small);
  if (record.contacts_are_overlaps)
    text += a.network ? "note      no contacts in the source: overlaps take their place, with F_n = k_n "
                        "overlap and no tangential forces\n"
                      : "note      no contacts in the source, and no two spheres overlap\n";
  if (a.network) text += network_text(a);
  for (const PairCorrelation& p : a.pairs) {
    const auto highest = static_cast<std::size_t>(std::max_element(p.g.begin(), p.g.end()) - p.g.begin());
    text += fmt::format("g(r)      {}: highest {:.2f} at {:.3f}, to {:.3f} in bins of {:.3g}\n",
                        name_of(p.kind), p.g[highest], p.centre(highest), p.edges.back(), p.edges[1]);
  }
  return text;
}

}  // namespace

Command analyze_command() {
  auto options = std::make_shared<AnalyzeOptions>();
  Command command;
  command.name = "analyze";
  command.does = "measure a packing: contacts, rattlers, forces, fabric, g(r)";
  command.example = "furnas analyze runs/first_packing --out analysis";
  command.setup = [options](CommandLine& app) {
    AnalysisOptions& analysis = options->analysis;
    add_packing_source(app, options->source, options->frame);
    app.add("--out", options->out, "folder for the files; default: that of the packing");
    app.add("--friction", options->friction,
            "mu, which sets the number of contacts that hold a particle (4 without friction, 2 with it) and "
            "the mobilisation abs(F_t)/(mu F_n); default: that of the run, 0 for a file")
        .between(0.0, 1e30);
    app.add("--backbone", options->backbone,
            "live contacts below which a particle is a rattler; default: 4 without friction, 2 with friction")
        .between(2, 4);
    app.add("--force-bin", analysis.force_bins.width, "width of the bins for forces [mean force]")
        .between(1e-3, 1e3)
        .showing_default();
    app.flag("--logarithmic", analysis.force_bins.logarithmic,
             "bins for forces of equal width in log(force), ten per decade");
    app.add("--reach", analysis.pair_correlation.reach,
            "largest distance of g(r) [d_s]; default: half of the cell, 2.5 to 5 large diameters")
        .above_zero();
    app.add("--bin", analysis.pair_correlation.bin, "width of the bins of g(r) [d_s]")
        .above_zero()
        .showing_default();
    app.flag("--no-pictures", options->no_pictures, "write the tables alone");
  };
  command.run = [options](Console console) {
    remark_on_older_checkpoint(options->source, console.err);
    const AnalysisRecord record = analyze_source(*options);
    if (!options->friction && !options->backbone && !record.friction_is_known)
      console.err << "furnas: the friction of this packing is not known and taken as 0, so that particles "
                     "with fewer than 4 contacts count as rattlers; with friction add --friction MU\n";
    const fs::path folder = folder_about(options->source, options->out);
    const std::vector<std::string> written = write_files(record, folder, !options->no_pictures, console);
    console.out << summary(record)
                << fmt::format("files     {}: {}\n", folder.string(), fmt::join(written, " "));
    return ExitCode::done;
  };
  return command;
}

}  // namespace furnas
