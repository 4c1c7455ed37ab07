#pragma once

#include <filesystem>
#include <string_view>

namespace furnas {

/// Opens a file for writing (O_WRONLY, O_CREAT and `flags`), writes a few bytes to its beginning and closes
/// it. Returns 0, or the error number of the call that failed. The file is not renamed: other workers of a
/// sweep must see the bytes at once, and NFS hides a renamed file for a minute, because NFS caches names.
int write_small_file(const std::filesystem::path& path, std::string_view text, int flags = 0);

/// Throws OutputError if `error` is an error number of a file that could not be written.
void require_written(const std::filesystem::path& path, int error);

}  // namespace furnas
