#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/plan.h"

namespace furnas {

/// What a sweep is to ask of Slurm; what is not said here follows from the samples.
struct SlurmWishes {
  std::string partition{};                         ///< empty: the cluster's default
  std::optional<int> cores{};                      ///< of a task
  std::optional<std::chrono::seconds> walltime{};  ///< of a task
};

/// Tasks of a job array, each of which is a worker on the sweep's folder.
struct SlurmArray {
  int tasks = 1;
  int cores = 1;                ///< of a task
  double memory{};              ///< of a task [bytes]
  std::chrono::minutes time{};  ///< that Slurm gives a task
};

/// As many tasks as bring the samples to their end in twice the time that is foretold for them. A task has a
/// core for each sample, sixteen at most; memory for the largest samples side by side; and, unless it is
/// told, twice the time of the longest sample on one core, from ten minutes to a day.
SlurmArray array_for(const std::vector<Sample>& samples, const SlurmWishes& wishes);

/// The script for sbatch. `command` is `furnas sweep ...`, less what follows from the array; a task that runs
/// out of time asks Slurm to begin it again.
std::string slurm_script(const SlurmArray& array, const SlurmWishes& wishes,
                         const std::vector<std::string>& command, const std::filesystem::path& folder);

}  // namespace furnas
