#pragma once

#include <filesystem>

#include "engine/state/packing.h"

namespace furnas {

/// Reads what write_vtp() writes, also after ParaView has saved it in its default way. Needed are the point
/// array radius and the field array cell (9 numbers); all other arrays are taken if there. Throws InputError.
Packing read_vtp(const std::filesystem::path& path);

}  // namespace furnas
