#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/points.h"
#include "engine/statistics/furnas_model.h"

namespace furnas {

/// What sweeps have found, in the order of the paper.
struct Study {
  std::vector<Point> mono;        ///< size ratio 1 with a jammed or settled sample, friction ascending
  std::vector<Curve> curves;      ///< larger size ratios, ascending, and for each its frictions, ascending
  std::vector<Point> points;      ///< all of them, whatever their verdicts
  std::filesystem::path history;  ///< of a jammed sample of the largest size ratio and friction; empty if no
                                  ///< folder has one

  /// phi_mono(mu) and the model that follows from it; none without samples of one size.
  std::optional<FurnasInterval> model(double friction) const;
  const Point* mono_at(double friction) const;                   ///< nullptr if there is none
  const Curve* curve(double size_ratio, double friction) const;  ///< nullptr if there is none
  std::vector<double> frictions() const;                         ///< of the curves, ascending
  std::vector<double> size_ratios() const;                       ///< of the curves, ascending
};

/// Reads the tables of the folders of sweeps. Of samples with several numbers of large spheres those with the
/// most count, and the same run in two folders once. Throws InputError, also when a sweep varies a key that
/// the paper does not.
Study study_of(const std::vector<std::filesystem::path>& folders);

}  // namespace furnas
