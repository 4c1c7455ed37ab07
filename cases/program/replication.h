#pragma once

#include <filesystem>
#include <string>

#include "cases/program/packing_source.h"
#include "engine/start/replicate.h"

namespace furnas {

/// "2x2x1" as three whole numbers; throws InputError.
Times parse_times(const std::string& text);

/// Three whole numbers as "2x2x1".
std::string text_of(const Times& times);

/// Writes a packing repeated `times` along its edges, in the format of the file's extension. A `.checkpoint`
/// keeps contacts, histories and the case. The larger packing is computed while it is written, so that it may
/// exceed the memory; a packing with contacts needs 60 bytes of memory per particle of the larger packing.
void write_replicate(const PackingSource& source, const Times& times, const std::filesystem::path& file);

}  // namespace furnas
