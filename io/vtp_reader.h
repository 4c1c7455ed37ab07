#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace furnas {

/// The arrays of a VTK XML file of poly data whose data are appended raw, plain or compressed with zlib, as
/// write_poly_data() and ParaView write them. All failures are InputErrors that name the file.
///
/// VTK's reader is not used: in VTK 9.1 it allocates any length that the file announces, and a damaged file
/// can make it crash. This reader allocates no more than the bytes of the file can expand to.
class VtpReader {
 public:
  /// Opens the file and reads which arrays it has.
  explicit VtpReader(const std::filesystem::path& path);

  /// How many points the file has.
  std::uint64_t points() const { return points_; }

  /// Whether there is an array; `section` is PointData, Points or FieldData.
  bool has(const std::string& section, const std::string& name) const;

  /// The numbers of an array, tuple after tuple; throws InputError if it is missing or has not `tuples` times
  /// `components` numbers.
  std::vector<double> numbers(const std::string& section, const std::string& name, std::uint64_t tuples,
                              std::uint64_t components);

  /// Throws InputError that names the file.
  [[noreturn]] void fail(std::string_view what) const;

 private:
  using Attributes = std::map<std::string, std::string, std::less<>>;

  /// Place and number type of an array.
  struct Array {
    std::string type;
    std::uint64_t components{};
    std::uint64_t offset{};  ///< in the appended data
  };

  void read_head();
  void read_tag(std::string_view kind, const Attributes& given);
  void file_tag(const Attributes& given);
  void array_tag(const Attributes& given);
  Attributes attributes(std::string_view text) const;
  std::string text(const Attributes& given, std::string_view key, const char* missing) const;
  std::uint64_t number(const Attributes& given, std::string_view key, std::uint64_t missing) const;

  std::string bytes(std::uint64_t offset, std::uint64_t expected);
  std::string unpack(std::uint64_t at, std::uint64_t expected);
  std::uint64_t size_at(std::uint64_t at);
  std::string get(std::uint64_t at, std::uint64_t count);

  std::string name_;
  std::uint64_t size_;
  std::ifstream stream_;
  std::uint64_t appended_ = 0;    ///< where the appended data begin
  std::uint64_t size_bytes_ = 4;  ///< of the sizes before appended data
  bool compressed_ = false;
  std::uint64_t points_ = 0;
  int pieces_ = 0;
  std::string section_;
  std::map<std::string, Array> arrays_;  ///< by section/name
};

}  // namespace furnas
