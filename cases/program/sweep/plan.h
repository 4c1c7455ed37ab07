#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/sweep_file.h"

namespace furnas {

/// How far a sample has come.
enum class SampleState {
  missing,      ///< there is nothing of it
  interrupted,  ///< there is a checkpoint to go on from
  finished      ///< it has ended, with whatever verdict
};

/// One run of a sweep.
struct Sample {
  Case resolved_case;
  std::vector<std::string> values;  ///< of the keys of the sweep
  std::filesystem::path folder;     ///< of the run
  double particles{};               ///< how many
  double steps{};                   ///< that it may take; a guess

  double cost() const { return particles * steps; }  ///< [particle-steps]
  double memory() const;                             ///< that it needs at its peak [bytes]

  /// Beside the folder: what the process of the run printed.
  std::filesystem::path log() const { return folder.string() + ".log"; }
};

/// The keys that tell the points of a sweep apart: size_ratio, small_fraction, friction, and what else takes
/// several values.
std::vector<std::string> keys_of(const SweepFile& sweep);

/// The folder of a run in that of its sweep: samples/<keys and values>/<seed>.
std::filesystem::path folder_of_sample(const std::vector<std::string>& keys,
                                       const std::vector<std::string>& values, std::int64_t seed);

/// A sample of the sweep into `folder`.
Sample sample_of(const Case& c, const std::vector<std::string>& keys, const std::filesystem::path& folder);

/// The samples that the file asks for, in its order. Throws InputError when a combination of values makes no
/// case, or two combinations with the same values of `keys` make different ones.
std::vector<Sample> samples_of(const SweepFile& sweep, const std::vector<std::string>& keys,
                               const std::filesystem::path& folder);

/// The same sample with another small_fraction.
Sample moved_to(const Sample& sample, double small_fraction, const std::vector<std::string>& keys,
                const std::filesystem::path& folder);

/// The samples in the folder beyond `planned`, as refining adds them: a planned case but for its
/// small_fraction.
std::vector<Sample> added_samples(const std::vector<Sample>& planned, const std::vector<std::string>& keys,
                                  const std::filesystem::path& folder);

/// How far it has come. Throws InputError when its folder holds another case.
SampleState state_of(const Sample& sample);

}  // namespace furnas
