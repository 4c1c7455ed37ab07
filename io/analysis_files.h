#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/analysis/analyze.h"
#include "io/output_field.h"

namespace furnas {

/// An analysis and the packing that it describes.
struct AnalysisRecord {
  Analysis analysis;
  std::string source;            ///< the folder or file of the packing
  std::int64_t step{};           ///< of the packing
  bool contacts_are_overlaps{};  ///< the source had no contacts, so overlaps count as contacts
  bool friction_is_known{};      ///< the source has a case, which has the friction
  std::optional<double> phi_J;   ///< only of a packing that was found jammed
};

/// A file that an analysis writes.
struct AnalysisFile {
  std::string_view name;
  std::string_view about;                ///< a sentence
  std::span<const OutputField> columns;  ///< of a table; none of analysis.json
  /// Its content; empty: there is nothing to write.
  std::string (*content)(const AnalysisRecord& record);
};

/// All such files: analysis.json and a table for each distribution.
std::span<const AnalysisFile> analysis_files();

/// The name of a kind, "large-large" and so on; "all" without a kind.
std::string_view name_of(const std::optional<PairKind>& kind);

/// The phi_J in the result.json of a run's folder; empty if there is no such file or phi_J is null. Throws
/// InputError when the file is damaged.
std::optional<double> read_phi_J(const std::filesystem::path& folder);

}  // namespace furnas
