#pragma once

#include <filesystem>
#include <string>

#include "cases/program/packing_source.h"
#include "engine/start/replicate.h"

namespace furnas {

/// "2x2x1" as three whole numbers; throws InputError.
Times parse_times(const std::string& text);

/// The opposite.
std::string text_of(const Times& times);

/// Writes a packing repeated `times` along its edges, in the format of the file's extension. A `.checkpoint`
/// keeps contacts, histories and the case. It is worked out while it is written, so that it may
/// be larger than this machine's memory, which holds 60 bytes a particle of one with contacts.
void write_replicate(const PackingSource& source, const Times& times, const std::filesystem::path& file);

}  // namespace furnas
