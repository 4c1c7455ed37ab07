#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace furnas {

/// One entry of a ParaView collection.
struct SavedFrame {
  double time{};     ///< [time]
  std::string file;  ///< relative to the folder of the collection
  friend bool operator==(const SavedFrame&, const SavedFrame&) = default;
};

/// The file of frame `number` beside a collection: frames/packing_000123.vtp.
std::string frame_file(std::size_t number);

/// Writes a ParaView collection anew; throws OutputError.
void write_frames(const std::vector<SavedFrame>& frames, const std::filesystem::path& path);

/// Reads a collection as write_frames() writes it, to continue it; throws InputError.
std::vector<SavedFrame> read_frames(const std::filesystem::path& path);

}  // namespace furnas
