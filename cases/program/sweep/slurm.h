#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/sweep/plan.h"

namespace furnas {

/// Wishes for the Slurm job of a sweep; values that are not set follow from the samples.
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
  std::chrono::minutes time{};  ///< time limit of a task
};

/// Enough tasks to finish the samples even if they take twice the estimated time. A task has a core for each
/// sample, at most sixteen, and memory for the largest samples side by side. Its time, unless given, is twice
/// that of the longest sample on one core, but at least ten minutes and at most a day.
SlurmArray array_for(const std::vector<Sample>& samples, const SlurmWishes& wishes);

/// The script for sbatch. `command` is `furnas sweep ...`, without the options that follow from the array. A
/// task that runs out of time requests Slurm to start it again.
std::string slurm_script(const SlurmArray& array, const SlurmWishes& wishes,
                         const std::vector<std::string>& command, const std::filesystem::path& folder);

}  // namespace furnas
