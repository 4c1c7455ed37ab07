#include "cases/program/bench/packings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ostream>
#include <set>

#include "cases/program/case_templates.h"
#include "cases/program/packing_source.h"
#include "engine/base/require.h"
#include "io/case_check.h"
#include "io/case_file.h"
#include "io/case_protocol.h"

namespace furnas {

namespace fs = std::filesystem;

std::vector<double> benchmark_ratios() {
  constexpr std::string_view prefix = "bench/alpha_";
  std::vector<double> ratios;
  for (const CaseTemplate& known : case_templates()) {
    double ratio = 0;
    if (known.file.starts_with(prefix) &&
        std::from_chars(known.file.data() + prefix.size(), known.file.data() + known.file.size(), ratio).ec ==
            std::errc{})
      ratios.push_back(ratio);
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

std::string benchmark_name(double size_ratio) { return fmt::format("alpha_{:g}", size_ratio); }

Times times_for(std::size_t particles, double wanted) {
  const double copies = wanted / static_cast<double>(particles);
  const auto most = static_cast<std::int32_t>(std::ceil(std::cbrt(std::max(copies, 1.0)))) + 1;
  Times best{1, 1, 1};
  const auto miss = [&](const Times& t) {
    return std::abs(std::log(static_cast<double>(copies_of(t)) / copies));
  };
  for (std::int32_t z = 1; z <= most; ++z)
    for (std::int32_t y = z; y <= std::min(2 * z, most); ++y)
      for (std::int32_t x = y; x <= std::min(2 * z, most); ++x)
        if (miss({x, y, z}) < miss(best)) best = {x, y, z};
  return best;
}

void add_packing_choice(CommandLine& app, PackingChoice& choice) {
  choice.ratios = benchmark_ratios();
  app.add("PACKING", choice.files,
          "packings in any format, or folders of runs; default: those that bench prepare has made");
  app.add("--packings", choice.folder, "folder of the prepared packings").showing_default();
  app.add("--ratios", choice.ratios, "size ratios").separated_by(',').showing_default();
  app.add("--sizes", choice.sizes, "numbers of particles, which repeating the cell comes close to")
      .separated_by(',')
      .showing_default();
}

namespace {

void prepared_packings(const PackingChoice& choice, double ratio, Console console,
                       const std::function<void(const std::string&, const Packing&)>& take) {
  const std::string name = benchmark_name(ratio);
  const fs::path folder = fs::path(choice.folder) / name;
  if (!fs::exists(folder))
    throw InputError(fmt::format("{}: no such packing; furnas bench prepare --out {} --ratios {:g} makes it",
                                 folder.string(), choice.folder, ratio));
  const Packing one = packing_from(folder.string());
  std::set<Times> done;
  for (const double size : choice.sizes) {
    const Times times = times_for(one.size(), size);
    if (2 * size < static_cast<double>(one.size()))
      console.err << fmt::format("{}: no packing of {:g} particles; the smallest has {}\n", name, size,
                                 one.size());
    else if (done.insert(times).second)
      take(name, replicate(one, times));
  }
}

}  // namespace

void for_each_packing(const PackingChoice& choice, Console console,
                      const std::function<void(const std::string&, const Packing&)>& take) {
  for (const std::string& file : choice.files) {
    const fs::path path = fs::path(file).lexically_normal();
    take((path.has_filename() ? path : path.parent_path()).stem().string(), packing_from(file));
  }
  if (!choice.files.empty()) return;
  for (const double ratio : choice.ratios) prepared_packings(choice, ratio, console, take);
}

Model model_for(const ModelChoice& choice, const Packing& packing) {
  Case c;
  // LAMMPS and the paper use the peculiar velocity, so their step is the one to measure.
  apply_override(c, "contact.velocity=peculiar");
  apply_override(c, "compaction.time_step=0.02");
  apply_override(c, "compaction.cell_damping=0");
  apply_override(c, "contact.law=" + choice.law);
  apply_override(c, fmt::format("contact.friction={:.17g}", choice.friction));
  apply_override(c, "compute.precision=" + choice.precision);
  validate(c);
  return model_of(c, packing);
}

}  // namespace furnas
