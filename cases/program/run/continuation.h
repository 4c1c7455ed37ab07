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

/// What a stopped run hands to the process that goes on with it, besides its packing and its case.
struct Continuation : RunState {
  double wall_seconds{};         ///< of all its processes
  double cpu_seconds{};          ///< of the threads of all its processes; NaN if one did not say
  std::optional<Verdict> ended;  ///< jammed or settled: nothing is left but to tell it
};

/// The continuation as it stands in a checkpoint, with the version of the program that wrote it.
std::map<std::string, std::string> to_extras(const Continuation& continuation);

/// The continuation that a checkpoint holds. Throws InputError if it is damaged, or if another version of the
/// program has written it, which might go on to other bits.
Continuation continuation_of(const Checkpoint& checkpoint);

/// The case of a stopped run, with the assignments of `set` in its place. The case file in the folder may ask
/// for other steps, threads, or whatever else changes no bit; throws InputError that names what differs if it
/// asks for another case.
Case case_to_go_on_with(const std::filesystem::path& folder, const Checkpoint& checkpoint,
                        std::span<const std::string> set);

/// The pressures at which a checkpointed run had come to rest.
std::vector<RestingState> resting_states_of(const Checkpoint& checkpoint);

}  // namespace furnas
