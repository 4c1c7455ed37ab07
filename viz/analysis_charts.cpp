#include "viz/analysis_charts.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "io/analysis_files.h"

namespace furnas {
namespace {

struct Look {
  Colour colour;
  Marker marker;
  LineStyle line;
};

/// Colour, marker and line of a kind, the same in all charts.
const Look& look_of(const std::optional<PairKind>& kind) {
  static const std::array<Look, 3> looks{{{blue, Marker::square, LineStyle::solid},
                                          {green, Marker::diamond, LineStyle::dashed},
                                          {vermilion, Marker::cross, LineStyle::dotted}}};
  return looks[static_cast<std::size_t>(kind.value_or(PairKind::large_large))];
}

/// The entries of the single kinds. The entry of all kinds together is left out, because it would hide them;
/// it is used only if there are no kinds.
template <class List>
std::vector<const typename List::value_type*> kinds_of(const List& all) {
  std::vector<const typename List::value_type*> kinds;
  for (const auto& each : all)
    if (each.kind || all.size() == 1) kinds.push_back(&each);
  return kinds;
}

/// The name in the legend; empty for a packing of one size, which has only one kind.
template <class List>
std::string legend_of(const List& all, const std::optional<PairKind>& kind) {
  return kinds_of(all).size() > 1 ? std::string(name_of(kind)) : "";
}

/// Densities at the middles of the bins, with the statistical error of the counts; empty bins are left out.
Series points_of(std::string name, const Histogram& h, const Look& look, bool logarithmic) {
  Series s{std::move(name), {}, {}, {}, look.colour, LineStyle::none, look.marker};
  for (std::size_t b = 0; b < h.bins(); ++b) {
    if (h.counts[b] == 0) continue;
    const double low = h.edges[b], high = h.edges[b + 1];
    s.x.push_back(logarithmic && low > 0 ? std::sqrt(low * high) : 0.5 * (low + high));
    s.y.push_back(h.density(b));
    const double error = h.density(b) / std::sqrt(static_cast<double>(h.counts[b]));
    s.bars.push_back({error, error});
  }
  return s;
}

/// Whether the bins are logarithmic: then their first edge is above 0.
bool grows(const Histogram& h) { return h.bins() > 1 && h.edges.front() > 0; }

Chart forces_chart(const NetworkAnalysis& network, ForceDistribution ContactAnalysis::*force,
                   const std::string& symbol) {
  Chart chart;
  chart.x.title = fmt::format("{0} / ⟨{0}⟩", symbol);
  chart.y.title = fmt::format("P({0} / ⟨{0}⟩)", symbol);
  chart.y.logarithmic = true;
  for (const ContactAnalysis* c : kinds_of(network.backbone)) {
    const Histogram& h = (c->*force).histogram;
    chart.x.logarithmic = chart.x.logarithmic || grows(h);
    chart.series.push_back(points_of(legend_of(network.backbone, c->kind), h, look_of(c->kind), grows(h)));
  }
  if (!chart.x.logarithmic) chart.x.low = 0;
  return chart;
}

Chart mobilisation_chart(const NetworkAnalysis& network, double friction) {
  Chart chart;
  chart.x.title = fmt::format("|F_t| / μF_n   (μ = {})", friction);
  chart.y.title = "probability density";
  chart.x.low = 0;
  chart.x.high = 1;
  chart.y.low = 0;
  for (const ContactAnalysis* c : kinds_of(network.backbone)) {
    const Histogram& h = c->mobilisation->histogram;
    std::vector<double> densities;
    for (std::size_t b = 0; b < h.bins(); ++b) densities.push_back(h.density(b));
    const Look look = look_of(c->kind);
    chart.series.push_back(
        steps(legend_of(network.backbone, c->kind), h.edges, densities, look.colour, look.line));
  }
  return chart;
}

Chart rattlers_chart(const Analysis& a) {
  Chart chart;
  chart.x.title = "force below which a contact does not count / ⟨F_n⟩ of its kind";
  chart.y.title = "share of rattlers";
  chart.x.logarithmic = true;
  chart.y.low = 0;
  constexpr Marker markers[] = {Marker::circle, Marker::square, Marker::diamond};
  const bool told_apart = a.has_species() && a.small > 0;
  for (const Species species : {Species::large, Species::small}) {
    const bool large = species == Species::large;
    const auto whole = static_cast<double>(large ? a.large : a.small);
    if (whole == 0) continue;
    for (std::size_t n = 0; n < 3; ++n) {
      const int least = static_cast<int>(n) + 2;
      const char* const who = !told_apart ? "" : large ? "large, " : "small, ";
      bool backbone_is_left = false;
      Series s{fmt::format("{}fewer than {} contacts", who, least), {},        {}, {}, series_colours[n],
               large ? LineStyle::solid : LineStyle::dashed,        markers[n]};
      for (const auto& [live_share, count] : a.network->rattlers) {
        if (count.least_contacts != least || live_share == 0) continue;
        backbone_is_left |= count.backbone > 0;
        s.x.push_back(live_share);
        s.y.push_back(static_cast<double>(large ? count.large : count.small) / whole);
      }
      if (backbone_is_left) chart.series.push_back(std::move(s));
    }
  }
  return chart;
}

Chart pair_correlation_chart(const std::vector<PairCorrelation>& pairs) {
  constexpr double nearest = 0.8, widest = 5;  // contact distances
  // The height of the peak at contact grows as the bins get narrower. A y axis up to this height would
  // flatten the rest of the curve.
  constexpr double highest = 4;
  const bool one_size = pairs.size() == 1;
  Chart chart;
  chart.x.title = one_size ? "r / d" : "r / d_{ab}";
  chart.y.title = one_size ? "g(r)" : "g_{ab}(r)";
  chart.x.low = nearest;
  chart.y.low = 0;
  chart.y.high = highest;
  for (const PairCorrelation* p : kinds_of(pairs)) {
    const Look look = look_of(p->kind);
    Series s{legend_of(pairs, p->kind), {}, {}, {}, look.colour, look.line};
    for (std::size_t b = 0; b < p->g.size() && p->centre(b) <= widest * p->contact; ++b) {
      if (p->centre(b) < (nearest - 0.1) * p->contact) continue;
      s.x.push_back(p->centre(b) / p->contact);
      s.y.push_back(p->g[b]);
    }
    chart.series.push_back(std::move(s));
  }
  return chart;
}

}  // namespace

std::vector<NamedChart> analysis_charts(const Analysis& a) {
  std::vector<NamedChart> charts;
  if (a.network) {
    charts.push_back({"normal_forces", forces_chart(*a.network, &ContactAnalysis::normal, "F_n")});
    if (a.friction > 0) {
      charts.push_back(
          {"tangential_forces", forces_chart(*a.network, &ContactAnalysis::tangential, "|F_t|")});
      charts.push_back({"mobilisation", mobilisation_chart(*a.network, a.friction)});
    }
    charts.push_back({"rattlers", rattlers_chart(a)});
  }
  if (!a.pairs.empty()) charts.push_back({"pair_correlation", pair_correlation_chart(a.pairs)});
  return charts;
}

}  // namespace furnas
