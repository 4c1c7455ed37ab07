#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "engine/start/replicate.h"
#include "engine/state/packing.h"

namespace furnas {

/// What is written to a checkpoint. The packing is not copied, because it may be large.
struct CheckpointView {
  const Packing& packing;
  std::string case_text;                      ///< as in Checkpoint
  std::map<std::string, std::string> extras;  ///< as in Checkpoint
};

/// All that a run needs to continue with the same bits.
struct Checkpoint {
  Packing packing;
  std::string case_text;                      ///< the resolved case file
  std::map<std::string, std::string> extras;  ///< whatever else the parts of a run must remember

  operator CheckpointView() const {
    return {packing, case_text, extras};
  }  ///< valid only while this checkpoint exists
};

/// The same for a replicate (a packing repeated along its edges), which is computed while it is written.
struct ReplicaCheckpoint {
  const Replica& packing;
  std::string case_text;                        ///< as in Checkpoint
  std::map<std::string, std::string> extras{};  ///< as in Checkpoint
};

/// The first bytes of every checkpoint.
inline constexpr std::string_view checkpoint_magic = "FURNASCP";

/// Whether a file begins with checkpoint_magic. Throws InputError if it cannot be opened.
bool is_checkpoint(const std::filesystem::path& path);

/// Writes a checkpoint, complete or not at all; every bit of the packing is kept. Throws OutputError.
void write_checkpoint(const CheckpointView& checkpoint, const std::filesystem::path& path);

/// Writes the same bytes as for a packing equal to the replicate, but needs memory only for memory_order().
void write_checkpoint(const ReplicaCheckpoint& checkpoint, const std::filesystem::path& path);

/// The step at which a checkpoint was saved, from its first bytes; throws InputError if those are damaged.
std::int64_t checkpoint_step(const std::filesystem::path& path);

/// Reads a checkpoint; throws InputError that names the file and the section if any bit is damaged, or if the
/// content is not a sound packing.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace furnas
