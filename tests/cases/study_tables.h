#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace furnas {

/// The folder of the results of the study.
inline std::filesystem::path study_folder() {
  return std::filesystem::path(FURNAS_SOURCE_DIR) / "docs/results/study";
}

/// The folders of its tables from which its figures are drawn (docs/results/study.md).
inline std::vector<std::filesystem::path> study_tables() {
  std::vector<std::filesystem::path> tables;
  for (const char* name : {"mono", "mono_10000", "alpha_2", "alpha_3", "alpha_5", "alpha_10", "alpha_20",
                           "alpha_20_light", "alpha_40_light"})
    tables.push_back(study_folder() / name);
  return tables;
}

}  // namespace furnas
