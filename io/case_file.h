#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "io/case.h"

namespace furnas {

/// Reads a case from TOML. Every error is an InputError of one line that names the file, the line, the key,
/// its value and what is allowed. `name` is the name of the file in errors; each of `overrides` is an
/// assignment as in `apply_override`.
Case parse_case(std::string_view toml, const std::string& name, std::span<const std::string> overrides = {});

/// Reads the case in a case file. Refuses a file with a sweep, which describes many cases (see
/// io/sweep_file.h). A relative start.file or mixture.diameters is relative to the folder of the case file,
/// or to the current directory if an override gives it; the returned case has the absolute path.
Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// Sets one key, e.g. "contact.friction=0.3", "compaction.pressure=[1e-3, 1e-4]" or
/// "contact.law=hooke_history", and resets its rival, the key for the same quantity in another unit. Checks
/// this key alone: call `validate` after the last override.
void apply_override(Case& c, std::string_view assignment);

/// The case as TOML with every default, its units and its documentation. Reading it gives the same case.
std::string resolved_toml(const Case& c);

}  // namespace furnas
