#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/analysis/analyze.h"

namespace furnas {

/// An analysis and what it is of.
struct AnalysisRecord {
  Analysis analysis;
  std::string source;            ///< the folder or file of the packing
  std::int64_t step{};           ///< of the packing
  bool contacts_are_overlaps{};  ///< the source had no contacts; its overlaps took their place
  std::optional<double> phi_J;   ///< only of a packing that was found jammed
};

/// A file that an analysis leaves.
struct AnalysisFile {
  const char* name;
  /// Its content; empty: there is nothing to write.
  std::string (*content)(const AnalysisRecord& record);
};

/// All of them: analysis.json and a table for each distribution.
std::span<const AnalysisFile> analysis_files();

/// "large-large" and so on, or "all".
std::string_view name_of(const std::optional<PairKind>& kind);

/// The phi_J that result.json in the folder of a run tells; nothing if there is none or it is null. Throws
/// InputError when the file is damaged.
std::optional<double> read_phi_J(const std::filesystem::path& folder);

}  // namespace furnas
