#pragma once

#include <string_view>

namespace furnas {

/// Version, compiler and flags of this build; CMake writes the values (cases/program/build_info.cpp.in).
struct BuildInfo {
  std::string_view version;
  std::string_view compiler;  ///< name and version
  std::string_view type;      ///< Release, Debug, ...
  std::string_view flags;     ///< of the compiler, including those of the build type
};

/// That of this program.
const BuildInfo& build_info();

}  // namespace furnas
