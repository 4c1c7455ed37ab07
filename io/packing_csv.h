#pragma once

#include <filesystem>

#include "engine/state/packing.h"

namespace furnas {

/// Writes a line of names and a line for each particle, with the columns of packing_csv_fields(). Throws
/// OutputError.
void write_packing_csv(const Packing& packing, const std::filesystem::path& path);

/// Writes a line of names and a line for each contact, with the columns of contacts_csv_fields(). Throws
/// OutputError.
void write_contacts_csv(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
