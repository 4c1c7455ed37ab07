#include "cases/program/bench/panels/threads_panel.h"

#include "cases/program/bench/speed.h"
#include "engine/base/parallel.h"
#include "engine/protocol/run.h"
#include "engine/start/mixture.h"
#include "engine/start/replicate.h"
#include "engine/state/fingerprint.h"

namespace furnas {
namespace {

/// A packing after a short compaction, repeated; most of its spheres have contacts.
Packing pressed_packing(Effort effort) {
  const bool full = effort == Effort::full;
  Protocol protocol;
  if (!full) protocol.pressures = {1e-2};
  protocol.steps = full ? 20'000 : 1500;
  Packing one = jam(dilute_start({.large = full ? 1000 : 60, .start_fraction = 0.2}), protocol).packing;
  return replicate(one, full ? Times{3, 2, 2} : Times{2, 2, 2});
}

std::vector<int> thread_counts() {
  const int all = available_threads();
  std::vector<int> counts{1, 2};
  while (2 * counts.back() <= all) counts.push_back(2 * counts.back());
  if (all > counts.back()) counts.push_back(all);
  return counts;
}

}  // namespace

std::vector<ThreadsRow> thread_rows(Effort effort) {
  SpeedOrder order;
  for (const int threads : thread_counts()) order.variants.push_back({"mixed", threads});
  if (effort == Effort::quick) order.steps = 20, order.repeats = 2;
  std::vector<ThreadsRow> rows;
  for (const SpeedRow& r : measure_speed("pressed", pressed_packing(effort), order)) {
    const double one = rows.empty() ? r.rate.median : rows.front().rate.median;
    rows.push_back({r.variant.threads,
                    r.particles,
                    r.rate,
                    {r.rate.median / one, r.rate.low / one, r.rate.high / one},
                    r.hash});
  }
  return rows;
}

PanelResult panel_of(const std::vector<ThreadsRow>& rows) {
  Table table({"threads", "particles", "rate_median", "rate_low", "rate_high", "speed_up", "speed_up_low",
               "speed_up_high", "state_hash"});
  Series is{"measured, range of the repeats"}, ideal{"ideal: n threads, n times as fast"};
  is.colour = blue, is.marker = Marker::circle;
  ideal.line = LineStyle::dotted;
  for (const ThreadsRow& r : rows) {
    table.row({std::to_string(r.threads), std::to_string(r.particles), panel_cell(r.rate.median),
               panel_cell(r.rate.low), panel_cell(r.rate.high), panel_cell(r.speed_up.median),
               panel_cell(r.speed_up.low), panel_cell(r.speed_up.high), hex(r.hash)});
    is.x.push_back(r.threads), ideal.x.push_back(r.threads);
    is.y.push_back(r.speed_up.median), ideal.y.push_back(r.threads);
    is.bars.push_back({r.speed_up.median - r.speed_up.low, r.speed_up.high - r.speed_up.median});
  }
  Chart chart;
  chart.x.title = "threads";
  chart.y.title = "speed-up (the same bits for any number of threads)";
  chart.y.low = 0;
  chart.series = {ideal, is};
  return {table, chart};
}

}  // namespace furnas
