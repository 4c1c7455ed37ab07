#pragma once

#include <string>

namespace furnas {

/// The page docs/reference/outputs.md: every field, column and array of the files of runs and sweeps, from
/// the tables that write them.
std::string output_page();

}  // namespace furnas
