#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/plan.h"
#include "io/case.h"
#include "io/case_schema.h"

namespace furnas {

/// The file in the folder of a sweep that holds the case of its samples: all agree in every key but those of
/// the tables and the seed.
inline constexpr const char* base_case_name = "base_case.toml";

/// The file as text.
std::string base_case_text(const std::vector<Sample>& samples, const std::vector<std::string>& keys);

/// The case of the samples of a sweep: base_case.toml, or where an older version made the sweep the
/// case.resolved.toml of a sample; nothing if there is neither, or this version cannot read it.
std::optional<Case> read_base_case(const std::filesystem::path& folder);

/// Whether samples that differ in a key may differ in what they say of phi_J: all but the seed, what only
/// writes files, how it is computed, how long it may take, and the name of a preset (its keys count). The
/// numbers of spheres (mixture.large) are left to those who ask.
bool bears_on_phi_J(const Key& key);

}  // namespace furnas
