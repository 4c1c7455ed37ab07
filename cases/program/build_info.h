#pragma once

#include <string_view>

namespace furnas {

/// What this program was built from; CMake writes the values (cases/build_info.cpp.in).
struct BuildInfo {
  std::string_view version;
  std::string_view compiler;  ///< name and version
  std::string_view type;      ///< Release, Debug, ...
  std::string_view flags;     ///< of the compiler, those of the build type included
};

const BuildInfo& build_info();

}  // namespace furnas
