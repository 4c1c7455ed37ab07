#include <fmt/format.h>
#include <hwy/highway.h>
#include <tbb/info.h>
#include <tbb/version.h>
#include <toml++/impl/version.h>
#include <vtkVersion.h>
#include <xxhash.h>
#include <zstd.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <memory>
#include <nlohmann/detail/abi_macros.hpp>
#include <ostream>

#include "cases/program/build_info.h"
#include "cases/program/commands/command.h"
#include "engine/kernels/kernels.h"
#include "engine/simulation.h"
#include "io/case_protocol.h"

namespace furnas {
namespace {

std::string dotted(unsigned long major, unsigned long minor, unsigned long patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

/// fmt and xxHash encode their version as major 10000 + minor 100 + patch.
std::string packed(unsigned long version) {
  return dotted(version / 10000, version / 100 % 100, version % 100);
}

ExitCode print_build(Console console) {
  const BuildInfo& build = build_info();
  const auto line = [&](std::string_view what, std::string_view value) {
    console.out << fmt::format("{:<14}{}\n", what, value);
  };
  line("furnas", build.version);
  line("compiler", build.compiler);
  line("build type", build.type);
  line("flags", build.flags);
  line("threads", std::to_string(tbb::info::default_concurrency()));
  line("instructions", to_string(instruction_set()));
  line("oneTBB", TBB_runtime_version());
  line("Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
  line("VTK", vtkVersion::GetVTKVersion());
  line("toml++", dotted(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH));
  line("JSON", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH));
  line("CLI11", CLI11_VERSION);
  line("Highway", dotted(HWY_MAJOR, HWY_MINOR, HWY_PATCH));
  line("fmt", packed(FMT_VERSION));
  line("zstd", ZSTD_versionString());
  line("xxHash", packed(XXH_versionNumber()));
  return ExitCode::done;
}

/// Draws the time step; the program itself makes the graph.
ExitCode draw_step(Console console) {
  Case c;
  c.mixture.large = 2;
  const Packing packing = start_of(c);
  make_simulation(model_of(c, packing), packing)->graph().write_dot(console.out);
  return ExitCode::done;
}

}  // namespace

Command info_command() {
  auto step = std::make_shared<bool>(false);
  return {
      .name = "info",
      .does = "show the version, the build, the libraries and the number of threads",
      .example = "furnas info --step | dot -Tsvg > step.svg",
      .setup =
          [step](CommandLine& app) {
            app.flag("--step", *step, "print a graph of the time step in the language of Graphviz instead");
          },
      .run = [step](Console console) { return *step ? draw_step(console) : print_build(console); },
  };
}

}  // namespace furnas
