#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/protocol/run.h"
#include "io/case.h"
#include "io/checkpoint.h"

namespace furnas {

/// The data, besides packing and case, with which another process continues a stopped run.
struct Continuation : RunState {
  double wall_seconds{};              ///< of all its processes
  double cpu_seconds{};               ///< of the threads of all its processes; NaN if one did not record it
  std::optional<double> listed_unit;  ///< 1 d_s in the unit of mixture.diameters; empty without a list
  std::optional<Verdict> ended;       ///< jammed or settled: only the result is left to write
};

/// The continuation in the form of a checkpoint, with the version of the program that writes it.
std::map<std::string, std::string> to_extras(const Continuation& continuation);

/// The continuation in a checkpoint. Throws InputError if it is damaged, or if another version of the program
/// has written it, because the versions might compute other bits.
Continuation continuation_of(const Checkpoint& checkpoint);

/// The case of a stopped run, changed by the assignments of `set`. The case file in the folder may have other
/// values of keys that change no bit, such as steps and threads. Throws InputError that names the difference
/// if another key has changed.
Case case_to_go_on_with(const std::filesystem::path& folder, const Checkpoint& checkpoint,
                        std::span<const std::string> set);

/// The pressures at which a checkpointed run had come to rest or settled.
std::vector<RestingState> resting_states_of(const Checkpoint& checkpoint);

}  // namespace furnas
