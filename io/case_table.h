#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "io/case.h"

namespace furnas {

/// The table of a case file that makes it a sweep.
inline constexpr const char* sweep_table = "sweep";
/// The table that makes it a comparison of arms (io/tradeoff_file.h).
inline constexpr const char* tradeoff_table = "tradeoff";

/// A case file as TOML; throws InputError, also for text that is not TOML.
toml::table read_table(const std::filesystem::path& file);

/// The case in such a file, whose sweep is ignored; otherwise as `read_case`.
Case case_in(const toml::table& root, const std::filesystem::path& file,
             std::span<const std::string> overrides);

/// The absolute path of the file that a key of a case file or of its sweep names, start.file or
/// mixture.diameters: a relative path is relative to the folder of the case file. Throws InputError that
/// begins with `place` if there is no such file.
std::string file_path(const std::filesystem::path& case_file, std::string_view key, const std::string& value,
                      const std::string& place);

}  // namespace furnas
