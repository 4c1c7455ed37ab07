#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/plan.h"
#include "io/case.h"
#include "io/case_schema.h"

namespace furnas {

/// The file in the folder of a sweep with the case of its samples. All samples agree in every key but the
/// seed and the keys of the sweep's tables.
inline constexpr const char* base_case_name = "base_case.toml";

/// The file as text.
std::string base_case_text(const std::vector<Sample>& samples, const std::vector<std::string>& keys);

/// The case of the samples of a sweep: base_case.toml or, in sweeps of older versions, the case.resolved.toml
/// of a sample; empty if there is neither, or if this version cannot read it.
std::optional<Case> read_base_case(const std::filesystem::path& folder);

/// Whether a key bears on phi_J. All keys do except the seed, the keys for output files, for the use of the
/// computer and for the length of a run, and the name of a preset (the keys that the preset sets do). The
/// function also returns false for mixture.large, which callers handle themselves.
bool bears_on_phi_J(const Key& key);

}  // namespace furnas
