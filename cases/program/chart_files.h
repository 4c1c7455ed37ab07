#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"
#include "viz/chart.h"

namespace furnas {

/// Writes FOLDER/NAME.svg and FOLDER/NAME.png, and returns the names of these two files. On a machine without
/// OpenGL, which only a PNG needs, a remark takes the place of the PNG. Throws OutputError.
std::vector<std::string> write_chart(const Chart& chart, const std::filesystem::path& folder,
                                     const std::string& name, Console console);

}  // namespace furnas
