#pragma once

#include <span>
#include <string_view>

namespace furnas {

/// A case file of cases/, as it stood when the program was built.
struct CaseTemplate {
  std::string_view file;  ///< its path from cases/, without ".toml"
  std::string_view text;
};

/// All case files of cases/; CMake writes them into the program, so that they are the only copy.
std::span<const CaseTemplate> case_templates();

}  // namespace furnas
