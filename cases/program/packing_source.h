#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/program/command_line.h"
#include "engine/events/at_rest.h"
#include "engine/state/packing.h"
#include "io/case.h"

namespace furnas {

/// A packing and, if it comes from a run, the run's case and the pressures reached.
struct PackingSource {
  Packing packing;
  std::optional<Case> of_case;
  std::vector<RestingState> reached;  ///< the pressures at which the run had come to rest or settled
};

/// The folder of a run (its newest checkpoint, with all contacts) or a file of any format; from a file with
/// several frames it reads the frame of this number, counted from 1, or the last. Throws InputError.
PackingSource packing_source(const std::string& folder_or_file, std::optional<std::int64_t> frame = {});

/// Prints a remark if the source is a checkpoint and its folder has a newer one.
void remark_on_older_checkpoint(const std::string& folder_or_file, std::ostream& out);

/// The case of a source. For a file without a case: the case of the run in whose folder or subfolder the file
/// is.
std::optional<Case> case_about(const PackingSource& source, const std::string& folder_or_file);

/// Declares the argument that names such a source, and the option for its frame.
void add_packing_source(CommandLine& app, std::string& name, std::optional<std::int64_t>& frame);

/// Declares only the option for the frame of a file.
void add_frame(CommandLine& app, std::optional<std::int64_t>& frame);

/// Prints which data of the packing a file of this format cannot store, if any.
void remark_on_losses(const Packing& packing, std::string_view format, std::ostream& out);

/// The folder for files about a packing: `wanted`, which is made if missing; without it the folder of the
/// run; without a run the folder of the packing's file. Throws InputError, also when there is a file of that
/// name.
std::filesystem::path folder_about(const std::string& folder_or_file, const std::string& wanted);

/// Makes the folder for `file` if it is missing. Throws InputError.
void make_folder_of(const std::filesystem::path& file);

/// The packing alone.
Packing packing_from(const std::string& folder_or_file);

/// The packing with its overlaps as contacts: each pushes with k_n overlap, and there is no friction.
Packing with_overlaps_as_contacts(const Packing& packing);

}  // namespace furnas
