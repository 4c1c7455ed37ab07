#pragma once

#include <filesystem>
#include <string>

namespace furnas {

/// Writes manifest.json: the program that made the folder of a run (`program`: name, version and build), and
/// each of its files with size in bytes and 64-bit XXH3 hash.
void write_manifest(const std::filesystem::path& folder, const std::string& program);

}  // namespace furnas
