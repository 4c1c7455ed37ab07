#include "io/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "io/atomic_file.h"

namespace furnas {
namespace {

/// The rows of an older file up to a step, with its header. A row that a crash has cut ends them.
std::string rows_until(const std::filesystem::path& path, std::int64_t step) {
  const std::string header = history_columns();
  const auto commas = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
  std::string kept = header + "\n";
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line) || line != header) return kept;
  while (std::getline(in, line) && !in.eof() && commas(line) == commas(header)) {
    std::int64_t row = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), row);
    if (error != std::errc{} || row > step) break;
    kept += line + "\n";
  }
  return kept;
}

}  // namespace

const char* history_columns() {
  return "Step,Time,Phi,Press,Pxx,Pyy,Pzz,Pxy,Pxz,Pyz,KinEng,KinEngBackbone,ForceImbalance,Contacts,Z,"
         "Backbone,SlidingShare,MaxOverlap,Volume,Lx,Ly,Lz,Xy,Xz,Yz";
}

History::History(std::filesystem::path path, std::int64_t step) : path_(std::move(path)) {
  write_file(path_, rows_until(path_, step));
  file_.open(path_, std::ios::app);
}

void History::add(const Measures& m) {
  const Triangle& h = m.cell.edges;
  const auto& s = m.stress;
  const auto& backbone = m.rattlers[static_cast<std::size_t>(m.backbone_threshold - 2)];
  file_ << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", m.step,
                       m.time, m.phi, m.pressure, s[0], s[1], s[2], s[3], s[4], s[5], m.kinetic_energy,
                       m.backbone_kinetic_energy, m.force_imbalance, m.contacts, m.coordination,
                       backbone.backbone, m.sliding_share, m.largest_overlap, m.cell.volume(), h.xx, h.yy,
                       h.zz, h.xy, h.xz, h.yz);
  file_.flush();
  if (!file_) throw OutputError("cannot write " + path_.string());
}

}  // namespace furnas
