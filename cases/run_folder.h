#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace furnas {

/// Makes the folder of a run: `wanted`, which must be new or empty, or runs/<case>, with a number when that
/// name is taken. Throws InputError.
std::filesystem::path create_run_folder(const std::string& wanted, const std::filesystem::path& case_file);

/// "90s", "30m", "2h", "1d" or plain seconds; throws InputError.
std::chrono::seconds parse_duration(const std::string& text);

}  // namespace furnas
