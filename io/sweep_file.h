#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/case.h"

namespace furnas {

/// The key whose value is a file.
inline constexpr const char* start_key = "start.file";

/// A key of the case and the values it takes in turn.
struct SweepAxis {
  std::string key;                  ///< "contact.friction"
  std::vector<std::string> values;  ///< as in an assignment of --set
};

/// All combinations of the values, each with so many seeds: mixture.seed, +1, +2 ...
struct SweepGrid {
  std::vector<SweepAxis> axes;
  int samples = 1;
  std::string place;  ///< where it stands, for errors: "study.toml:12"
};

/// A case with [sweep] or several [[sweep]] in it.
struct SweepFile {
  Case base;
  std::vector<SweepGrid> grids;
};

/// Whether a case file has a sweep in it. Throws InputError when it cannot be read.
bool holds_sweep(const std::filesystem::path& file);

/// Reads a case file that has a sweep in it, with the assignments of `overrides` in its case. Every key of a
/// grid is a key of the case in quotes with one value or a list of them; `samples` is how many seeds. A
/// start.file of a grid lies beside the case file, too. Errors are those of read_case.
SweepFile read_sweep(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// A case without a sweep in it as one of a single point, of which a number of seeds may be asked for. Errors
/// are those of read_case.
SweepFile sweep_of_one_point(const std::filesystem::path& file, std::span<const std::string> overrides = {});

}  // namespace furnas
