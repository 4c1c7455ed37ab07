#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"
#include "engine/model.h"
#include "engine/start/replicate.h"
#include "engine/state/packing.h"

namespace furnas {

/// Size ratios that have a case in cases/bench/.
std::vector<double> benchmark_ratios();

/// Name of the case and of its folder: "alpha_5".
std::string benchmark_name(double size_ratio);

/// How often to repeat a packing of `particles` along each edge, so that the result has about `wanted`
/// particles and its edges differ by less than a factor of two.
Times times_for(std::size_t particles, double wanted);

/// Which packings to measure: files, or prepared packings of these size ratios, repeated to these sizes.
struct PackingChoice {
  std::vector<std::string>
      files;  ///< packings in any format, or folders of runs; if given, prepared packings are not used
  std::string folder = "bench";                   ///< folder in which `bench prepare` has put packings
  std::vector<double> ratios;                     ///< of the diameters
  std::vector<double> sizes{1e3, 1e4, 1e5, 1e6};  ///< particles
};

/// Declares the options of a choice.
void add_packing_choice(CommandLine& app, PackingChoice& choice);

/// Calls `take` with each packing of the choice and its name. Throws InputError for a packing that does not
/// exist; prints which sizes are not possible.
void for_each_packing(const PackingChoice& choice, Console console,
                      const std::function<void(const std::string& name, const Packing& packing)>& take);

/// Which model to measure, by keys of a case.
struct ModelChoice {
  std::string law = "hooke_synchronized";  ///< contact.law
  double friction = 0.3;                   ///< contact.friction
  std::string precision = "mixed";         ///< compute.precision
};

/// The model for a packing. Throws InputError for values that a case may not have.
Model model_for(const ModelChoice& choice, const Packing& packing);

}  // namespace furnas
