#pragma once

#include <filesystem>
#include <string>

namespace furnas {

/// What differs between the folders of two runs that should be the same; empty if nothing does. Left out are
/// times and what follows from them (wall_seconds, million_particle_steps_per_second), what depends on
/// where a process began (lists_built), the number of threads, and the name of the folder.
std::string difference(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace furnas
