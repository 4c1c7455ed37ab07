#include "io/lammps_header.h"

#include <fmt/format.h>

#include <algorithm>

namespace furnas {

void LammpsHeader::take(const TextReader& reader, const std::vector<std::string_view>& words,
                        std::vector<std::string> names) {
  const std::size_t n = words.size();
  if (n == 2 && words[1] == "atoms") {
    count_ = reader.particle_count(words[0], least_row);
  } else if (n == 3 && words[1] == "atom" && words[2] == "types") {
    types_ = reader.integer(words[0], "the number of atom types");
    // A comment with as many words as there are types gives their names; any other comment is ignored.
    if (static_cast<std::int64_t>(names.size()) == *types_) names_ = std::move(names);
  } else if (!take_bounds(reader, words) && !take_edges(reader, words) && words[0] != "0") {
    // "0 bonds" and similar lines announce nothing and are ignored.
    reader.fail(
        "unknown line in the header; expected 'N atoms', 'N atom types', 'lo hi xlo xhi' (y, z), "
        "'a b c xy xz yz', 'x y z avec' (bvec, cvec) or 'x y z abc origin'");
  }
}

bool LammpsHeader::take_bounds(const TextReader& reader, const std::vector<std::string_view>& words) {
  if (words.size() == 4 && words[2].size() == 3 && words[2].ends_with("lo") && words[2][0] >= 'x' &&
      words[2][0] <= 'z') {
    bounds_[static_cast<std::size_t>(words[2][0] - 'x')] = {reader.real(words[0], "the lower bound"),
                                                            reader.real(words[1], "the upper bound")};
    return true;
  }
  if (words.size() != 6 || words[3] != "xy" || words[4] != "xz" || words[5] != "yz") return false;
  tilts_.xy = reader.real(words[0], "xy");
  tilts_.xz = reader.real(words[1], "xz");
  tilts_.yz = reader.real(words[2], "yz");
  return true;
}

bool LammpsHeader::take_edges(const TextReader& reader, const std::vector<std::string_view>& words) {
  const auto vector = [&] {
    return Vec3<double>{reader.real(words[0], words[3]), reader.real(words[1], words[3]),
                        reader.real(words[2], words[3])};
  };
  if (words.size() == 5 && words[3] == "abc" && words[4] == "origin") {
    corner_ = vector();
    return true;
  }
  if (words.size() != 4 || words[3].size() != 4 || !words[3].ends_with("vec") || words[3][0] < 'a' ||
      words[3][0] > 'c')
    return false;
  edges_[static_cast<std::size_t>(words[3][0] - 'a')] = vector();
  return true;
}

void LammpsHeader::finish(const TextReader& reader) {
  if (!count_) reader.fail("the header has no line 'N atoms' after the title, which is the first line");
  if (std::any_of(edges_.begin(), edges_.end(), [](const auto& edge) { return edge.has_value(); })) {
    for (std::size_t a = 0; a < 3; ++a)
      if (!edges_[a]) reader.fail(fmt::format("the header has no line 'x y z {}vec'", "abc"[a]));
    cell_ = FileCell(*edges_[0], *edges_[1], *edges_[2], corner_);
  } else {
    for (std::size_t a = 0; a < 3; ++a)
      if (!bounds_[a]) reader.fail(fmt::format("the header has no line 'lo hi {0}lo {0}hi'", "xyz"[a]));
    Triangle edges = tilts_;
    edges.xx = (*bounds_[0])[1] - (*bounds_[0])[0];
    edges.yy = (*bounds_[1])[1] - (*bounds_[1])[0];
    edges.zz = (*bounds_[2])[1] - (*bounds_[2])[0];
    cell_ = FileCell(edges, {(*bounds_[0])[0], (*bounds_[1])[0], (*bounds_[2])[0]});
  }
  cell_.check(reader);
}

}  // namespace furnas
