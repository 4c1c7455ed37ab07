#include "cases/program/figures/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/program/sweep/finite_size.h"

namespace furnas {
namespace {

const char* text_of(Agreement agreement) {
  switch (agreement) {
    case Agreement::reproduced:
      return "reproduced";
    case Agreement::not_excluded:
      return "not excluded";
    case Agreement::not_reproduced:
      return "not reproduced";
    case Agreement::not_reachable:
      break;
  }
  return "not reachable here";
}

std::string statements_table(const Study& study) {
  std::string text =
      "| statement | paper | here (95 % intervals) | n | verdict | counts as reproduced when |\n"
      "|---|---|---|---|---|---|\n";
  for (const Statement& s : statements_of(study))
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", s.what, s.paper, s.ours, s.n,
                        text_of(s.agreement), s.rule);
  return text;
}

std::string mono_table(const Study& study) {
  std::string text = "| μ | φ_mono | ± (95 %) | n | model f_max | model φ_max |\n|---|---|---|---|---|---|\n";
  for (const Point& p : study.mono) {
    const FurnasInterval model = *study.model(p.friction);
    const Interval f = model.f_max(), phi = model.phi_max();
    text += fmt::format("| {} | {:.4f} | {} | {} | {:.4f} ({:.4f} to {:.4f}) | {:.4f} ({:.4f} to {:.4f}) |\n",
                        p.friction, p.mean_phi_J->mean,
                        p.mean_phi_J->samples > 1 ? fmt::format("{:.4f}", p.mean_phi_J->half_width) : "-",
                        p.mean_phi_J->samples, f.value, f.low, f.high, phi.value, phi.low, phi.high);
  }
  return text;
}

std::string maxima_table(const Study& study) {
  std::string text = "| α | μ | f_max (95 %) | φ_max | ± (95 %) | n |\n|---|---|---|---|---|---|\n";
  for (const Curve& curve : study.curves)
    if (const auto m = maximum_of(curve))
      text += fmt::format("| {} | {} | {:.3f} ({:.3f} to {:.3f}) | {:.4f} | {} | {} |\n", curve.size_ratio(),
                          curve.friction(), m->f_max, m->f_max_low, m->f_max_high, m->phi_max.mean,
                          m->phi_max.samples > 1 ? fmt::format("{:.4f}", m->phi_max.half_width) : "-",
                          m->phi_max.samples);
  return text;
}

std::string points_table(const Study& study) {
  std::string text =
      "| α | μ | f_s | p_a | preset | N_l | N_s | jammed | settled | budget | diverged, failed | unfinished "
      "| "
      "φ_J | ± (95 %) | finite size | effective size | thickness |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Point& p : study.points) {
    if (p.unfinished == p.samples) continue;  // without a finished sample there is nothing to report
    const auto& phi = p.mean_phi_J;
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} | {} of {} | {} | {} | {} | {} | {} | {} | {} | {:.0f} | {}{} "
        "|\n",
        p.size_ratio, p.friction, p.small_fraction,
        std::isfinite(p.pressure) ? fmt::format("{}", p.pressure) : "-", p.preset.empty() ? "-" : p.preset,
        p.large, p.small, p.jammed, p.samples, p.settled, p.budget, p.diverged + p.failed, p.unfinished,
        phi ? fmt::format("{:.4f}", phi->mean) : "-",
        phi && phi->samples > 1 ? fmt::format("{:.4f}", phi->half_width) : "-",
        phi ? finite_size_text(p) : "-", p.effective_size, thickness_text(p),
        p.too_thin() ? ", too thin" : "");
  }
  return text;
}

}  // namespace

std::string report(const Study& study, const std::vector<Figure>& figures) {
  std::string text = R"(# The sweeps beside the paper

Srivastava, Roberts, Clemmer, Silbert, Lechman, Grest, *Jamming of bidisperse frictional spheres* (arXiv 2105.00977).
Written by `furnas figures`. Means are over jammed samples and, where a table counts some, settled samples. phi of a settled sample has a bound on its
further change, which widens the interval. Intervals are 95 % intervals of Student's t; n is the number of samples.
*By pooled scatter*: one or two samples tell next to nothing of their scatter. At size ratios from 5 on it is taken from all points of two samples
or more with size ratio 5 or more, on the same side of f_max (below, within 0.03, above), with friction or without it like the point itself; or from
those in which the same spheres carry the load, the large ones alone or small ones, too, if these points scatter more. A sample with N_l large spheres
is taken to scatter as N_l^(-1/2). The tables of maxima and samples have Student's interval alone.
*Not excluded*: a number differs from that of the paper by more than the tolerance in the last column, but not by more than tolerance and half width of
the interval together. *Not reachable here*: there are no samples for the statement, or so few or so small ones that their intervals do not decide it.
)";
  text += fmt::format(
      "A cell thinner than {} largest diameters is too thin to represent a large packing: its points are "
      "drawn with open symbols and are not used for any statement.\n\n",
      least_thickness);
  for (const std::string& remark : study.remarks) text += remark + ".\n\n";
  text += statements_table(study);
  if (!study.mono.empty()) text += "\n## Equal spheres, and the model that follows\n\n" + mono_table(study);
  if (!study.curves.empty()) text += "\n## The densest mixtures\n\n" + maxima_table(study);
  text +=
      "\n## Samples\n\nThe effective size is the number of backbone spheres of all jammed and settled "
      "samples together. Where the small spheres rattle only the large ones count. Finite size: φ_J of a "
      "large packing minus φ_J of a packing of this many spheres, as far as this study has measured it. "
      "Thickness: of "
      "the thinnest cell, in largest diameters; an upper bound, marked at most, where tables of older "
      "versions do not contain it. "
      "Points of which no sample is finished are left out.\n\n";
  text += points_table(study);
  text += "\n## Figures\n";
  for (const Figure& f : figures) text += fmt::format("\n![{}]({}.svg)\n\n{}\n", f.name, f.name, f.caption);
  return text;
}

}  // namespace furnas
