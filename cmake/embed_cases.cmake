# Writes the case files of cases/, the stored table of biases and the facts of the build into sources of the program.

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

# What `furnas check` knows of biases.
set(furnas_tradeoff_table ${PROJECT_SOURCE_DIR}/docs/results/tradeoff/tradeoff.csv)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${furnas_tradeoff_table})
file(READ ${furnas_tradeoff_table} furnas_tradeoff_text)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/stored_tradeoff.cpp @ONLY CONTENT
[[#include "cases/program/bench/tradeoff/known_bias.h"

namespace furnas {

std::string_view stored_tradeoff() {
  return R"furnas(@furnas_tradeoff_text@)furnas";
}

}  // namespace furnas
]])

string(TOUPPER "${CMAKE_BUILD_TYPE}" furnas_build_type)
list(JOIN furnas_arithmetic " " furnas_options)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${furnas_build_type}} ${furnas_options}" furnas_build_flags)
configure_file(${PROJECT_SOURCE_DIR}/cases/program/build_info.cpp.in ${PROJECT_BINARY_DIR}/generated/build_info.cpp @ONLY)

target_sources(furnas_program PRIVATE ${PROJECT_BINARY_DIR}/generated/case_templates.cpp
                                      ${PROJECT_BINARY_DIR}/generated/build_info.cpp
                                      ${PROJECT_BINARY_DIR}/generated/stored_tradeoff.cpp)
