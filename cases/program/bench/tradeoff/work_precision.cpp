#include "cases/program/bench/tradeoff/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace furnas {
namespace {

Series points(const char* name, const Colour& colour, Marker marker) {
  Series s{name};
  s.colour = colour;
  s.marker = marker;
  s.line = LineStyle::none;
  return s;
}

/// In the text of a chart, "_" makes the next letter a subscript.
std::string words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string verdicts(const ComparedArm& arm) {
  std::string text;
  const auto add = [&](std::size_t n, const char* what) {
    if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", what, n);
  };
  add(arm.budget, "budget"), add(arm.diverged, "diverged"), add(arm.failed, "failed");
  add(arm.unfinished, "unfinished");
  return text;
}

std::string label_of(const ComparedArm& arm) {
  const std::string lost = verdicts(arm);
  return words(arm.arm) + (lost.empty() ? "" : fmt::format(" ({} of {})", lost, arm.samples));
}

class WorkPrecision {
 public:
  explicit WorkPrecision(const ComparedCase& compared) : compared_(compared) {}

  Chart chart() {
    for (const ComparedArm& arm : compared_.arms)
      if (arm.core_seconds) add(arm);
    add_failed();
    add_margin();
    Chart chart;
    chart.title = fmt::format("{}, reference: {}", words(compared_.name), words(compared_.reference));
    chart.x.title = "core seconds to the end of a sample";
    chart.y.title = "|φ − φ of the reference|, 95 % interval";
    chart.x.logarithmic = chart.y.logarithmic = true;
    // Leaves room for the labels beside the first and the last point.
    chart.x.low = first_ / 2, chart.x.high = last_ * 2;
    chart.y.low = lowest_ / 3, chart.y.high = top_ * 3;
    chart.notes = std::move(notes_);
    chart.width = 1600;
    chart.height = 1100;
    for (Series* s : {&margin_, &equivalent_, &different_, &undecided_, &reference_, &failed_})
      if (!s->x.empty()) chart.series.push_back(std::move(*s));
    return chart;
  }

 private:
  void reach(double seconds, double low, double high) {
    first_ = std::min(first_, seconds), last_ = std::max(last_, seconds);
    lowest_ = std::min(lowest_, low), top_ = std::max(top_, high);
  }

  void add(const ComparedArm& arm) {
    const double seconds = std::max(arm.core_seconds->median, 1e-3);
    if (arm.standing == Standing::failed) {
      reach(seconds, compared_.margin, compared_.margin);
      return;
    }
    if (arm.standing == Standing::reference) {
      const double own = std::isfinite(arm.phi->half_width) ? arm.phi->half_width : compared_.margin;
      put(reference_, arm, seconds, std::max(own, least), {});
      return;
    }
    const double size = std::max(std::abs(arm.difference->mean), least);
    const double half = std::isfinite(arm.difference->half_width) ? arm.difference->half_width : 0;
    Series& series = arm.standing == Standing::equivalent  ? equivalent_
                     : arm.standing == Standing::different ? different_
                                                           : undecided_;
    put(series, arm, seconds, size, {half, half});
  }

  void put(Series& series, const ComparedArm& arm, double seconds, double y, const Bar& bar) {
    series.x.push_back(seconds);
    series.y.push_back(y);
    series.bars.push_back(bar);
    notes_.push_back({seconds, y, label_of(arm)});
    reach(seconds, y, y + bar.above);
  }

  void add_failed() {
    top_ *= 2;
    for (const ComparedArm& arm : compared_.arms) {
      if (arm.standing != Standing::failed || !arm.core_seconds) continue;
      const double seconds = std::max(arm.core_seconds->median, 1e-3);
      failed_.x.push_back(seconds);
      failed_.y.push_back(top_);
      notes_.push_back({seconds, top_, label_of(arm)});
    }
  }

  void add_margin() {
    margin_.x = {first_ / 2, last_ * 2};
    margin_.y = {compared_.margin, compared_.margin};
  }

  /// A smaller difference is drawn at this value. It is far below the scatter of phi between samples, 1e-3.
  static constexpr double least = 1e-8;

  const ComparedCase& compared_;
  double first_ = 1e300, last_ = 1e-300, lowest_ = compared_.margin, top_ = compared_.margin;
  std::vector<ChartNote> notes_;
  Series equivalent_ = points("equivalent", green, Marker::circle);
  Series different_ = points("different", vermilion, Marker::square);
  Series undecided_ = points("undecided", blue, Marker::diamond);
  Series reference_ = points("reference: interval of its mean", black, Marker::plus);
  Series failed_ = points("failed: no φ", purple, Marker::cross);
  Series margin_{.name = "margin", .line = LineStyle::dashed};
};

}  // namespace

Chart work_precision_chart(const ComparedCase& compared) {
  const ComparedArm* reference = compared.reference_arm();
  if (reference == nullptr || reference->standing != Standing::reference) return {};
  return WorkPrecision(compared).chart();
}

}  // namespace furnas
