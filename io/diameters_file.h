#pragma once

#include <filesystem>
#include <vector>

namespace furnas {

/// Diameters that were listed in a file.
struct DiameterList {
  std::vector<double> diameters;  ///< in the order of the file, divided by the smallest [d_s]
  double unit{};                  ///< the smallest diameter, which is 1 d_s, in the unit of the file
};

/// Reads a list of diameters: text with one diameter per line, in any unit; text after # is a comment. Throws
/// InputError, also for a diameter that is not above zero.
DiameterList read_diameters(const std::filesystem::path& path);

}  // namespace furnas
