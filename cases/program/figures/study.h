#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/points.h"
#include "engine/statistics/furnas_model.h"

namespace furnas {

/// The results of sweeps, in the order of the paper.
struct Study {
  std::vector<Point> mono;        ///< size ratio 1 with a jammed or settled sample, friction ascending
  std::vector<Curve> curves;      ///< larger size ratios, ascending, and for each its frictions, ascending
  std::vector<Point> points;      ///< all points, for any verdicts
  std::filesystem::path history;  ///< of a jammed sample of the largest size ratio and friction; empty if no
                                  ///< folder has one
  std::vector<std::string> remarks;  ///< remarks for the reader, in sentences

  /// phi_mono(mu) and the model that follows from it; empty without samples of equal spheres.
  std::optional<FurnasInterval> model(double friction) const;
  /// The study without the points, of equal spheres and of curves, whose cells are too thin to
  /// represent large packings.
  Study without_thin_cells() const;
  const Point* mono_at(double friction) const;                   ///< nullptr if there is none
  const Curve* curve(double size_ratio, double friction) const;  ///< nullptr if there is none
  std::vector<double> frictions() const;                         ///< of the curves, ascending
  std::vector<double> size_ratios() const;                       ///< of the curves, ascending
};

/// The model for the phi_mono of some samples; its interval is cut to possible packing fractions.
FurnasInterval furnas_model_of(const MeanInterval& phi_mono);

/// Reads the tables of the folders of sweeps. Of samples at one point with different numbers of large spheres
/// it uses those with the most; it counts the same run in two folders once. Throws InputError, also when
/// samples differ in a key that bears on phi_J and that the paper does not vary.
Study study_of(const std::vector<std::filesystem::path>& folders);

}  // namespace furnas
