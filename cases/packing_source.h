#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "engine/state/packing.h"
#include "io/case.h"

namespace furnas {

/// A packing and, where it comes from a run, the run's case.
struct PackingSource {
  Packing packing;
  std::optional<Case> of_case;
};

/// The folder of a run (its newest checkpoint, with all contacts) or a file of any format.
PackingSource packing_source(const std::string& folder_or_file);

/// Declares the argument that names such a source, into `name`.
void add_packing_source(CLI::App& app, std::string& name);

/// The packing alone.
Packing packing_from(const std::string& folder_or_file);

/// The packing with its overlaps as contacts: each pushes with k_n overlap, and there is no friction.
Packing with_overlaps_as_contacts(const Packing& packing);

}  // namespace furnas
