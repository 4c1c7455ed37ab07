#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "engine/start/replicate.h"
#include "engine/state/packing.h"

namespace furnas {

/// What is written of a checkpoint; the packing stays where it is, for it may be large.
struct CheckpointView {
  const Packing& packing;
  std::string case_text;                      ///< as in Checkpoint
  std::map<std::string, std::string> extras;  ///< as in Checkpoint
};

/// All that a run needs to go on exactly.
struct Checkpoint {
  Packing packing;
  std::string case_text;                      ///< the resolved case file
  std::map<std::string, std::string> extras;  ///< whatever else the parts of a run must remember

  operator CheckpointView() const { return {packing, case_text, extras}; }  ///< lives no longer than this
};

/// The same of a replicate, which is worked out while it is written.
struct ReplicaCheckpoint {
  const Replica& packing;
  std::string case_text;                        ///< as in Checkpoint
  std::map<std::string, std::string> extras{};  ///< as in Checkpoint
};

/// The first bytes of every checkpoint.
inline constexpr std::string_view checkpoint_magic = "FURNASCP";

/// Whether a file begins as a checkpoint does; not if it cannot be read.
bool is_checkpoint(const std::filesystem::path& path);

/// Writes a checkpoint, complete or not at all; every bit of the packing is kept. Throws OutputError.
void write_checkpoint(const CheckpointView& checkpoint, const std::filesystem::path& path);

/// The same bytes as those of the replicate as a packing. Needs memory for its memory_order() alone.
void write_checkpoint(const ReplicaCheckpoint& checkpoint, const std::filesystem::path& path);

/// The step at which a checkpoint was saved, from its first bytes; throws InputError if those are damaged.
std::int64_t checkpoint_step(const std::filesystem::path& path);

/// Reads a checkpoint; throws InputError that names the file and the section if it is damaged in any bit, or
/// if what it holds is no packing.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace furnas
