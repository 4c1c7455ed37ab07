#include "io/vtp_writer.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <new>
#include <string>

#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

/// Most bytes that are compressed together.
constexpr std::size_t most_in_block = std::size_t{1} << 20;
constexpr int compression_level = 5;  // VTK's own choice

constexpr std::string_view field_tag = "FieldData";
constexpr std::string_view opening =
    R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor">
  <PolyData>
)";
constexpr std::string_view before_data = R"(    </Piece>
  </PolyData>
  <AppendedData encoding="raw">
   _)";
constexpr std::string_view closing = R"(
  </AppendedData>
</VTKFile>
)";

/// Arrays within one XML tag.
struct Section {
  std::string_view tag;
  std::vector<DataArray> arrays;
  std::vector<std::uint64_t> offsets{};  ///< of the written arrays, in the appended data
};

/// Cells of consecutive points.
Section cells(std::string_view tag, std::size_t count, std::size_t points_each) {
  const auto point = [](std::size_t k) { return static_cast<std::int64_t>(k); };
  const auto end = [=](std::size_t k) { return static_cast<std::int64_t>((k + 1) * points_each); };
  return {tag, {data_array("connectivity", count * points_each, point), data_array("offsets", count, end)}};
}

/// The section as XML. Its length is the same before the offsets are known and afterwards.
std::string in_xml(const Section& section) {
  std::string text = fmt::format("      <{}>\n", section.tag);
  for (std::size_t k = 0; k < section.arrays.size(); ++k) {
    const DataArray& array = section.arrays[k];
    const std::uint64_t offset = k < section.offsets.size() ? section.offsets[k] : 0;
    text += fmt::format(R"(        <DataArray type="{}" Name="{}" NumberOfComponents="{}" )", array.type,
                        array.name, array.components);
    if (section.tag == field_tag) text += fmt::format(R"(NumberOfTuples="{}" )", array.count);
    text += fmt::format("format=\"appended\" offset={:<22}/>\n", fmt::format("\"{}\"", offset));
  }
  return text + fmt::format("      </{}>\n", section.tag);
}

/// Writes one file, an array after the other.
class PolyDataWriter {
 public:
  PolyDataWriter(const PolyData& data, const std::filesystem::path& path)
      : points_(data.points.count), file_(path) {
    require(data.points_of_a_cell == 1 || data.points_of_a_cell == 2, "a cell is a vertex or a line");
    (data.points_of_a_cell == 1 ? vertices_ : lines_) = points_ / data.points_of_a_cell;
    const auto have = [](const std::vector<DataArray>& arrays, std::size_t count) {
      return std::all_of(arrays.begin(), arrays.end(), [&](const DataArray& a) { return a.count == count; });
    };
    require(have(data.of_points, points_) && have(data.of_cells, vertices_ + lines_),
            "an array has an element for each point or cell");
    if (!data.field.empty()) field_.push_back({field_tag, data.field});
    piece_ = {{"PointData", data.of_points}, {"CellData", data.of_cells}, {"Points", {data.points}},
              cells("Verts", vertices_, 1),  cells("Lines", lines_, 2),   cells("Strips", 0, 0),
              cells("Polys", 0, 0)};
  }

  /// The offsets are known only when all arrays are written; then the head is written a second time.
  void write() {
    file_.write(head());
    const std::uint64_t data_begin = file_.size();
    for (std::vector<Section>* sections : {&field_, &piece_})
      for (Section& section : *sections)
        for (const DataArray& array : section.arrays) {
          section.offsets.push_back(file_.size() - data_begin);
          append(array);
        }
    file_.write(closing);
    file_.overwrite(0, head());
    file_.commit();
  }

 private:
  std::string head() const {
    std::string text(opening);
    for (const Section& section : field_) text += in_xml(section);
    text += fmt::format(
        "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"0\">\n",
        points_, vertices_, lines_);
    for (const Section& section : piece_) text += in_xml(section);
    text += before_data;
    return text;
  }

  /// Number of blocks, bytes of a block, bytes of the last one if it is shorter, the stored size of each, and
  /// then the blocks.
  void append(const DataArray& array) {
    const std::size_t in_block = most_in_block / array.element_size;
    const std::size_t blocks = (array.count + in_block - 1) / in_block;
    std::vector<std::uint64_t> sizes(3 + blocks);
    sizes[0] = blocks;
    sizes[1] = in_block * array.element_size;
    sizes[2] = array.count % in_block * array.element_size;
    const std::string_view stored_sizes{reinterpret_cast<const char*>(sizes.data()), 8 * sizes.size()};
    const std::uint64_t at = file_.size();
    file_.write(stored_sizes);
    for (std::size_t k = 0; k < blocks; ++k) {
      const std::size_t first = k * in_block;
      raw_.resize(std::min(in_block, array.count - first) * array.element_size);
      array.fill(first, raw_);
      sizes[3 + k] = append_block();
    }
    file_.overwrite(at, stored_sizes);
  }

  /// Compresses `raw_`; returns the number of compressed bytes.
  std::uint64_t append_block() {
    uLongf stored = compressBound(raw_.size());
    compressed_.resize(stored);
    const int answer = compress2(reinterpret_cast<Bytef*>(compressed_.data()), &stored,
                                 reinterpret_cast<const Bytef*>(raw_.data()), raw_.size(), compression_level);
    if (answer == Z_MEM_ERROR) throw std::bad_alloc();
    require(answer == Z_OK, "zlib compresses a block into a buffer of the size it asked for");
    file_.write({compressed_.data(), stored});
    return stored;
  }

  std::size_t points_, vertices_ = 0, lines_ = 0;
  std::vector<Section> field_, piece_;  ///< sections before the only <Piece>, and in it
  std::vector<char> raw_, compressed_;
  AtomicFile file_;
};

}  // namespace

void write_poly_data(const PolyData& data, const std::filesystem::path& path) {
  PolyDataWriter(data, path).write();
}

}  // namespace furnas
