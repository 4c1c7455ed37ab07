#pragma once

#include <filesystem>
#include <span>

#include "engine/state/packing.h"
#include "io/result.h"

namespace furnas {

/// A finished or stopped run: the data from which the files of its folder are written.
struct RunRecord {
  const Case& resolved_case;
  const Packing& packing;
  const Result& result;
};

/// A file that every run leaves in its folder.
struct Output {
  const char* file;
  void (*write)(const RunRecord& run, const std::filesystem::path& path);
};

/// All files that a run leaves at its end.
std::span<const Output> outputs();

/// Writes them all.
void write_outputs(const RunRecord& run, const std::filesystem::path& folder);

}  // namespace furnas
