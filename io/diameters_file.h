#pragma once

#include <filesystem>
#include <vector>

namespace furnas {

/// Diameters that were listed in a file.
struct DiameterList {
  std::vector<double> diameters;  ///< in the order of the file, over the smallest [d_s]
  double unit{};                  ///< the smallest, in the unit of the file: that is one d_s
};

/// Reads a list of diameters: text with one a line, in any unit; what follows a # is a remark. Throws
/// InputError, also for one that is not above zero.
DiameterList read_diameters(const std::filesystem::path& path);

}  // namespace furnas
