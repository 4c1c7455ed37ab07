#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/sweep_file.h"

namespace furnas {

/// The key of f_s, along which a curve goes.
inline constexpr const char* fraction_key = "mixture.small_fraction";

/// The keys in which the samples of the paper differ: mixture.size_ratio, mixture.small_fraction,
/// contact.friction.
const std::vector<std::string>& keys_of_the_paper();

/// A key without the name of its table: "friction".
std::string name_in(const std::string& key);

/// State of a sample.
enum class SampleState {
  missing,      ///< it has no files
  interrupted,  ///< it has a checkpoint to continue from
  finished      ///< it has ended, with any verdict
};

/// One run of a sweep.
struct Sample {
  Case resolved_case;
  std::vector<std::string> values;  ///< of the keys of the sweep
  std::filesystem::path folder;     ///< of the run
  double particles{};               ///< number of particles
  double steps{};                   ///< estimated number of steps

  double cost() const { return particles * steps; }  ///< [particle-steps]
  double memory() const;                             ///< peak memory [bytes]

  /// The file beside the folder with the output of the run's process.
  std::filesystem::path log() const { return folder.string() + ".log"; }
};

/// The keys that differ between points of a sweep: those of the paper, and further keys with several values.
std::vector<std::string> keys_of(const SweepFile& sweep);

/// The folder of a run in that of its sweep: samples/<keys and values>/<seed>.
std::filesystem::path folder_of_sample(const std::vector<std::string>& keys,
                                       const std::vector<std::string>& values, std::int64_t seed);

/// A sample of the sweep in `folder`.
Sample sample_of(const Case& c, const std::vector<std::string>& keys, const std::filesystem::path& folder);

/// The samples of the file, in its order. Throws InputError when a combination of values is not a valid case,
/// or when two combinations with the same values of `keys` are different cases.
std::vector<Sample> samples_of(const SweepFile& sweep, const std::vector<std::string>& keys,
                               const std::filesystem::path& folder);

/// The same sample with another small_fraction.
Sample moved_to(const Sample& sample, double small_fraction, const std::vector<std::string>& keys,
                const std::filesystem::path& folder);

/// The files case.resolved.toml of all samples in the folder of a sweep, in the order of their paths.
std::vector<std::filesystem::path> resolved_cases_in(const std::filesystem::path& folder);

/// The samples in the folder beyond `planned`, as refining adds them: cases that differ from a planned one
/// only in small_fraction.
std::vector<Sample> added_samples(const std::vector<Sample>& planned, const std::vector<std::string>& keys,
                                  const std::filesystem::path& folder);

/// The state of a sample. Throws InputError when its folder contains another case.
SampleState state_of(const Sample& sample);

}  // namespace furnas
