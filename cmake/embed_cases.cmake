# Writes the case files of cases/ and the facts of the build into two sources of the program.

file(GLOB_RECURSE furnas_case_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.toml)
set(furnas_case_entries "")
foreach(case_file IN LISTS furnas_case_files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${case_file})
  cmake_path(RELATIVE_PATH case_file BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/cases OUTPUT_VARIABLE case_name)
  cmake_path(REMOVE_EXTENSION case_name)
  file(READ ${case_file} case_text)
  string(APPEND furnas_case_entries "    {\"${case_name}\", R\"furnas(${case_text})furnas\"},\n")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/case_templates.cpp @ONLY CONTENT
[[#include "cases/program/case_templates.h"

#include <array>

namespace furnas {

std::span<const CaseTemplate> case_templates() {
  static constexpr auto templates = std::to_array<CaseTemplate>({
@furnas_case_entries@  });
  return templates;
}

}  // namespace furnas
]])

string(TOUPPER "${CMAKE_BUILD_TYPE}" furnas_build_type)
list(JOIN furnas_arithmetic " " furnas_options)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${furnas_build_type}} ${furnas_options}" furnas_build_flags)
configure_file(${PROJECT_SOURCE_DIR}/cases/program/build_info.cpp.in ${PROJECT_BINARY_DIR}/generated/build_info.cpp @ONLY)

target_sources(furnas_program PRIVATE ${PROJECT_BINARY_DIR}/generated/case_templates.cpp
                                      ${PROJECT_BINARY_DIR}/generated/build_info.cpp)
