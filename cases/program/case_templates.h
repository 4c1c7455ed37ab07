#pragma once

#include <span>
#include <string_view>

namespace furnas {

/// A case file of cases/, as it was when the program was built.
struct CaseTemplate {
  std::string_view file;  ///< its path from cases/, without ".toml"
  std::string_view text;
};

/// All case files of cases/. CMake compiles the files themselves into the program, so there is no second copy
/// to maintain.
std::span<const CaseTemplate> case_templates();

}  // namespace furnas
