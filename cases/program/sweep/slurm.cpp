#include "cases/program/sweep/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "cases/program/preflight.h"
#include "cases/program/shell_word.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

using std::chrono::minutes;

/// Safety factor on estimated times.
constexpr double reserve = 2;
constexpr int most_cores = 16;

double memory_of(const std::vector<Sample>& samples, int side_by_side) {
  std::vector<double> each;
  each.reserve(samples.size());
  for (const Sample& sample : samples) each.push_back(sample.memory());
  std::sort(each.begin(), each.end(), std::greater<>());
  each.resize(std::min(each.size(), static_cast<std::size_t>(side_by_side)));
  constexpr double of_the_worker = 100e6, inexact = 1.2;
  double sum = of_the_worker;
  for (const double bytes : each) sum += inexact * bytes;
  return sum;
}

int rounded_up(double number) { return static_cast<int>(std::ceil(std::min(number, 1e6))); }

/// Slurm ends a task without a request, so its samples must be saved before.
minutes time_of_worker(minutes of_task) {
  return of_task - std::max(minutes(1), std::min(minutes(5), of_task / 10));
}

/// A text between the quotes of a #SBATCH line, in which Slurm replaces % and a letter.
std::string in_quotes(const std::string& text) {
  std::string quoted;
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    if (letter == '%') quoted += '%';
    quoted += letter;
  }
  return quoted;
}

}  // namespace

SlurmArray array_for(const std::vector<Sample>& samples, const SlurmWishes& wishes) {
  if (wishes.walltime && *wishes.walltime < minutes(2))
    throw InputError("--walltime of a Slurm task is at least 2m, of which one is for saving the samples");
  const int count = std::max(1, static_cast<int>(samples.size()));
  double all = 0, longest = 0;  // [s of a core]
  for (const Sample& sample : samples) {
    all += sample.cost() / pace_of_a_core;
    longest = std::max(longest, sample.cost() / pace_of_a_core);
  }
  SlurmArray array;
  array.cores = wishes.cores.value_or(std::min(count, most_cores));
  array.memory = memory_of(samples, array.cores);
  const minutes foretold(rounded_up(reserve * longest / 60));
  array.time = wishes.walltime ? std::chrono::ceil<minutes>(*wishes.walltime)
                               : std::clamp(foretold, minutes(10), minutes(24 * 60));
  const double a_task = array.cores * std::chrono::duration<double>(array.time).count();
  array.tasks = std::clamp(rounded_up(reserve * all / a_task), 1, rounded_up(1.0 * count / array.cores));
  return array;
}

std::string slurm_script(const SlurmArray& array, const SlurmWishes& wishes,
                         const std::vector<std::string>& command, const std::filesystem::path& folder) {
  std::string line;
  for (const std::string& word : command) line += shell_word(word) + " ";
  const std::string output = in_quotes(folder.string()) + "/slurm-%A_%a.out";
  return fmt::format(
      R"(#!/bin/bash
# Each task is a worker on the sweep's folder: it runs samples that no other worker runs, and saves in time.
#SBATCH --job-name="furnas-{name}"
#SBATCH --array=1-{tasks}
{partition}#SBATCH --time={minutes}
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={cores}
#SBATCH --mem={megabytes}M
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output="{output}"

{line}\
  --jobs "${{SLURM_CPUS_PER_TASK:-{cores}}}" --walltime {worker}m --leave
code=$?
# 11: the time is spent and samples are left; Slurm starts this task again, which continues them.
if [ $code -eq 11 ]; then scontrol requeue "$SLURM_JOB_ID"; fi
exit $code
)",
      fmt::arg("name", in_quotes(folder.filename().string())), fmt::arg("tasks", array.tasks),
      fmt::arg("partition",
               wishes.partition.empty() ? "" : fmt::format("#SBATCH --partition={}\n", wishes.partition)),
      fmt::arg("minutes", array.time.count()), fmt::arg("cores", array.cores),
      fmt::arg("megabytes", std::ceil(array.memory / 1e6)), fmt::arg("output", output),
      fmt::arg("line", line), fmt::arg("worker", time_of_worker(array.time).count()));
}

}  // namespace furnas
