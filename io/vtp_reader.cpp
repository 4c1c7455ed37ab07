#include "io/vtp_reader.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// zlib expands one byte to at most this many.
constexpr std::uint64_t most_growth = 1032;

template <class T>
std::vector<double> as_real(const std::string& bytes) {
  std::vector<double> values(bytes.size() / sizeof(T));
  for (std::size_t k = 0; k < values.size(); ++k) {
    T value;
    std::memcpy(&value, bytes.data() + k * sizeof(T), sizeof(T));
    values[k] = static_cast<double>(value);
  }
  return values;
}

/// A type of numbers in VTK XML files.
struct NumberType {
  std::string_view name;
  std::uint64_t size;  ///< bytes
  std::vector<double> (*as_real)(const std::string& bytes);
};

constexpr NumberType number_types[] = {
    {"Int8", 1, as_real<std::int8_t>},   {"UInt8", 1, as_real<std::uint8_t>},
    {"Int16", 2, as_real<std::int16_t>}, {"UInt16", 2, as_real<std::uint16_t>},
    {"Int32", 4, as_real<std::int32_t>}, {"UInt32", 4, as_real<std::uint32_t>},
    {"Int64", 8, as_real<std::int64_t>}, {"UInt64", 8, as_real<std::uint64_t>},
    {"Float32", 4, as_real<float>},      {"Float64", 8, as_real<double>},
};

}  // namespace

VtpReader::VtpReader(const std::filesystem::path& path)
    : name_(path.string()), size_(readable_size(path)), stream_(open_file(path)) {
  read_head();
}

void VtpReader::fail(std::string_view what) const { throw InputError(fmt::format("{}: {}", name_, what)); }

bool VtpReader::has(const std::string& section, const std::string& name) const {
  return arrays_.contains(section + "/" + name);
}

void VtpReader::read_head() {
  constexpr std::uint64_t longest_head = std::uint64_t{1} << 20;
  std::string head = get(0, std::min(size_, longest_head));
  const std::size_t end = head.find("<AppendedData");
  const std::size_t begin = end == std::string::npos ? end : head.find('_', end);
  if (begin == std::string::npos ||
      head.substr(end, begin - end).find("encoding=\"raw\"") == std::string::npos)
    fail("expected a VTK XML file with its data appended raw, <AppendedData encoding=\"raw\">");
  appended_ = begin + 1;
  head.resize(end);
  for (std::size_t at = head.find('<'); at != std::string::npos; at = head.find('<', at + 1)) {
    const std::size_t close = head.find('>', at);
    if (close == std::string::npos) fail("a tag of its XML is not closed");
    const std::string_view tag(head.data() + at + 1, close - at - 1);
    const std::string_view kind = tag.substr(0, tag.find_first_of(" \t\r\n/"));
    read_tag(kind, attributes(tag.substr(kind.size())));
  }
  if (pieces_ != 1) fail("expected a file of type PolyData with one <Piece>");
}

VtpReader::Attributes VtpReader::attributes(std::string_view text) const {
  Attributes found;
  for (std::size_t equals = text.find('='); equals != text.npos; equals = text.find('=')) {
    std::string_view key = text.substr(0, equals);
    key.remove_prefix(std::min(key.find_first_not_of(blanks), key.size()));
    const std::size_t begin = text.find('"', equals);
    const std::size_t end = begin == text.npos ? begin : text.find('"', begin + 1);
    if (end == text.npos) fail("an attribute in its XML has no value in quotes");
    found.emplace(key, text.substr(begin + 1, end - begin - 1));
    text.remove_prefix(end + 1);
  }
  return found;
}

std::string VtpReader::text(const Attributes& given, std::string_view key, const char* missing) const {
  const auto found = given.find(key);
  return found == given.end() ? missing : found->second;
}

std::uint64_t VtpReader::number(const Attributes& given, std::string_view key, std::uint64_t missing) const {
  const auto found = given.find(key);
  if (found == given.end()) return missing;
  const std::string& word = found->second;
  const std::optional<std::uint64_t> value = number_in<std::uint64_t>(word);
  if (!value || *value > size_ * most_growth)
    fail(fmt::format("{} is no whole number that a file of {} bytes can hold", key, size_));
  return *value;
}

void VtpReader::read_tag(std::string_view kind, const Attributes& given) {
  for (const std::string_view section :
       {"FieldData", "PointData", "CellData", "Points", "Verts", "Lines", "Strips", "Polys"})
    if (kind == section) section_ = section;
  if (kind == "VTKFile") file_tag(given);
  if (kind == "Piece") ++pieces_, points_ = number(given, "NumberOfPoints", 0);
  if (kind == "DataArray") array_tag(given);
}

void VtpReader::file_tag(const Attributes& given) {
  const std::string header = text(given, "header_type", "UInt32"), compressor = text(given, "compressor", "");
  if (text(given, "type", "") != "PolyData") fail(R"(expected <VTKFile type="PolyData">)");
  if (text(given, "byte_order", "") != "LittleEndian") fail(R"(expected byte_order="LittleEndian")");
  if (header != "UInt32" && header != "UInt64") fail(R"(expected header_type="UInt32" or "UInt64")");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    fail(R"(expected compressor="vtkZLibDataCompressor" or none)");
  size_bytes_ = header == "UInt64" ? 8 : 4;
  compressed_ = !compressor.empty();
}

void VtpReader::array_tag(const Attributes& given) {
  const std::string key = section_ + "/" + text(given, "Name", "");
  if (text(given, "format", "") != "appended") fail("the array " + key + " is not appended");
  Array array{text(given, "type", ""), number(given, "NumberOfComponents", 1), number(given, "offset", 0)};
  if (!arrays_.emplace(key, std::move(array)).second) fail("the array " + key + " occurs twice");
}

std::vector<double> VtpReader::numbers(const std::string& section, const std::string& name,
                                       std::uint64_t tuples, std::uint64_t components) {
  const auto found = arrays_.find(section + "/" + name);
  if (found == arrays_.end()) fail(fmt::format("there is no array {} in {}", name, section));
  const Array& array = found->second;
  const auto type = std::find_if(std::begin(number_types), std::end(number_types),
                                 [&](const NumberType& t) { return t.name == array.type; });
  if (type == std::end(number_types)) fail("the array " + name + " has no numbers");
  if (array.components != components)
    fail(fmt::format("the array {} has {} components; expected {}", name, array.components, components));
  try {
    return type->as_real(bytes(array.offset, tuples * components * type->size));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}, in the array {}", error.what(), name));
  }
}

std::string VtpReader::get(std::uint64_t at, std::uint64_t count) {
  if (at > size_ || count > size_ - at) fail("the data reach beyond the end of the file");
  std::string found(static_cast<std::size_t>(count), '\0');
  stream_.seekg(static_cast<std::streamoff>(at));
  if (!stream_.read(found.data(), static_cast<std::streamsize>(count))) fail("cannot be read");
  return found;
}

std::uint64_t VtpReader::size_at(std::uint64_t at) {
  const std::string found = get(at, size_bytes_);
  std::uint64_t value = 0;
  std::memcpy(&value, found.data(), found.size());
  return value;
}

std::string VtpReader::bytes(std::uint64_t offset, std::uint64_t expected) {
  const std::uint64_t at = appended_ + offset;
  if (compressed_) return unpack(at, expected);
  if (size_at(at) != expected) fail("the data have another length than expected");
  return get(at + size_bytes_, expected);
}

/// Compressed data: number of blocks, bytes of a block, bytes of the last one if it is shorter, the stored
/// size of each, and then the blocks.
std::string VtpReader::unpack(std::uint64_t at, std::uint64_t expected) {
  const std::uint64_t blocks = size_at(at), block = size_at(at + size_bytes_),
                      last = size_at(at + 2 * size_bytes_);
  std::uint64_t sizes = at + 3 * size_bytes_;
  if (blocks > (size_ - at) / size_bytes_) fail("the data reach beyond the end of the file");
  std::uint64_t from = sizes + blocks * size_bytes_;
  std::string result;
  for (std::uint64_t k = 0; k < blocks; ++k, sizes += size_bytes_) {
    const std::string stored = get(from, size_at(sizes));
    const std::uint64_t size = k + 1 == blocks && last != 0 ? last : block;
    if (size > stored.size() * most_growth || size > expected - result.size())
      fail("the data have another length than expected");
    const std::size_t begin = result.size();
    result.resize(begin + static_cast<std::size_t>(size));
    uLongf made = size;
    const int outcome = uncompress(reinterpret_cast<Bytef*>(result.data() + begin), &made,
                                   reinterpret_cast<const Bytef*>(stored.data()), stored.size());
    if (outcome == Z_MEM_ERROR) throw std::bad_alloc();
    if (outcome != Z_OK || made != size) fail("the data cannot be decompressed");
    from += stored.size();
  }
  if (result.size() != expected) fail("the data have another length than expected");
  return result;
}

}  // namespace furnas
