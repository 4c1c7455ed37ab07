#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/case.h"

namespace furnas {

/// The key whose value is the path of a start.
inline constexpr const char* start_key = "start.file";

/// A key of the case and its values in the sweep.
struct SweepAxis {
  std::string key;                  ///< "contact.friction"
  std::vector<std::string> values;  ///< as in an assignment of --set
};

/// All combinations of the values, each with a number of seeds: mixture.seed, mixture.seed + 1, ...
struct SweepGrid {
  std::vector<SweepAxis> axes;
  int samples = 1;
  std::string place;  ///< its place in the file, for errors: "study.toml:12"
};

/// A case with [sweep], or with several [[sweep]].
struct SweepFile {
  Case base;
  std::vector<SweepGrid> grids;
};

/// Whether a case file contains a sweep. Throws InputError when it cannot be read.
bool holds_sweep(const std::filesystem::path& file);

/// Reads a case file that has a sweep in it, with the assignments of `overrides` applied to its case. Every
/// key of a grid is a key of the case in quotes, with one value or a list of values; `samples` is the number
/// of seeds. A start.file or mixture.diameters of a grid is relative to the folder of the case file, too.
/// Throws as read_case does.
SweepFile read_sweep(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// A case without a sweep, as a sweep of a single point for which several seeds may be requested. Throws as
/// read_case does.
SweepFile sweep_of_one_point(const std::filesystem::path& file, std::span<const std::string> overrides = {});

}  // namespace furnas
