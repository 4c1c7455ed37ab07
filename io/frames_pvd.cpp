#include "io/frames_pvd.h"

#include <fmt/format.h>

#include "engine/base/require.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

constexpr std::string_view pvd_head =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
constexpr std::string_view pvd_tail = "  </Collection>\n</VTKFile>\n";

/// The value of name="value" in the current line.
std::string attribute(const TextReader& reader, const std::string& name) {
  const std::string key = " " + name + "=\"";
  const std::size_t at = reader.line().find(key);
  const std::size_t begin = at + key.size();
  const std::size_t end = at == std::string::npos ? at : reader.line().find('"', begin);
  if (end == std::string::npos) reader.fail("<DataSet ...> needs " + name + "=\"...\" in the same line");
  return reader.line().substr(begin, end - begin);
}

}  // namespace

std::string frame_file(std::size_t number) { return fmt::format("frames/packing_{:06}.vtp", number); }

std::string frames_text(const std::vector<SavedFrame>& frames) {
  std::string text(pvd_head);
  for (const SavedFrame& frame : frames) {
    require(frame.file.find_first_of("<>&\"\n") == std::string::npos, "file names of frames need no escapes");
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time, frame.file);
  }
  return text.append(pvd_tail);
}

std::vector<SavedFrame> read_frames(const std::filesystem::path& path) {
  TextReader reader(path);
  std::vector<SavedFrame> frames;
  bool collection = false, complete = false;
  while (reader.next_line()) {
    if (reader.line().find("type=\"Collection\"") != std::string::npos) collection = true;
    if (reader.line().find("</VTKFile>") != std::string::npos) complete = true;
    if (reader.line().find("<DataSet ") == std::string::npos) continue;
    frames.push_back({reader.real(attribute(reader, "timestep"), "timestep"), attribute(reader, "file")});
  }
  if (!collection) reader.fail_at(0, "not a ParaView collection; expected <VTKFile type=\"Collection\" ...>");
  if (!complete) reader.fail("the file ends without </VTKFile>");
  return frames;
}

}  // namespace furnas
