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

/// A ParaView collection of these frames.
std::string frames_text(const std::vector<SavedFrame>& frames);

/// Reads a collection as frames_text() gives it, to continue it; throws InputError.
std::vector<SavedFrame> read_frames(const std::filesystem::path& path);

}  // namespace furnas
