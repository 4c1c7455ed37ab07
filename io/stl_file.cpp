#include "io/stl_file.h"

#include <bit>
#include <cstring>
#include <limits>
#include <string>

#include "engine/base/require.h"

namespace furnas {
namespace {

static_assert(std::endian::native == std::endian::little, "STL files are little-endian");

constexpr std::size_t bytes_of_title = 80;

bool same(const Vec3<float>& a, const Vec3<float>& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

Vec3<float> normal_of(const std::array<Vec3<float>, 3>& c) {
  const Vec3<float> n = cross(c[1] - c[0], c[2] - c[0]);
  const float length = norm(n);
  return length > 0 ? (1 / length) * n : Vec3<float>{};
}

}  // namespace

StlFile::StlFile(const std::filesystem::path& path) : file_(path) {
  std::string head(bytes_of_head, '\0');
  const std::string title = "furnas: lengths in d_s";  // must not begin with "solid", as text files do
  head.replace(0, title.size(), title);
  file_.write(head);
}

void StlFile::add(const std::array<Vec3<float>, 3>& corners) {
  if (same(corners[0], corners[1]) || same(corners[1], corners[2]) || same(corners[2], corners[0])) return;
  if (count_ == std::numeric_limits<std::uint32_t>::max())
    throw InputError("an STL file holds at most 4294967295 triangles; allowed: a longer --edge");
  ++count_;
  std::array<char, bytes_of_triangle> row{};
  std::size_t at = 0;
  const Vec3<float> normal = normal_of(corners);
  for (const Vec3<float>* v : {&normal, &corners[0], &corners[1], &corners[2]})
    for (const float x : {v->x, v->y, v->z}) {
      std::memcpy(row.data() + at, &x, sizeof x);
      at += sizeof x;
    }
  file_.write({row.data(), row.size()});
}

void StlFile::commit() {
  std::array<char, sizeof count_> bytes{};
  std::memcpy(bytes.data(), &count_, sizeof count_);
  file_.overwrite(bytes_of_title, {bytes.data(), bytes.size()});
  file_.commit();
}

}  // namespace furnas
