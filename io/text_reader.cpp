#include "io/text_reader.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <new>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "engine/state/packing.h"
#include "io/species_type.h"

namespace furnas {
namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }

/// A word in a form fit for a message: shortened, and without control characters for the terminal.
std::string quoted(std::string_view word) {
  std::string text = "'";
  for (char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 40 ? "...'" : "'");
}

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

std::uint64_t readable_size(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string() + ": there is no such file");
  if (std::filesystem::is_directory(status))
    throw InputError(path.string() +
                     " is a folder; allowed: a file, as packing.vtp or a.checkpoint in the folder of a run");
  if (!std::filesystem::is_regular_file(status)) throw InputError(path.string() + ": not a regular file");
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path.string() + ": " + error.message());
  return size;
}

std::ifstream open_file(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream) return stream;
  if (errno == ENOMEM) throw std::bad_alloc();
  throw InputError(path.string() + ": cannot be opened for reading");
}

void read_in_parts(std::ifstream& file, const std::filesystem::path& path,
                   const std::function<void(std::string_view)>& visit) {
  std::array<char, 1 << 16> part{};
  while (file.read(part.data(), part.size()), file.gcount() > 0)
    visit({part.data(), static_cast<std::size_t>(file.gcount())});
  if (file.bad()) throw InputError(path.string() + ": cannot be read to its end");
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file = open_file(path);
  std::string text;
  read_in_parts(file, path, [&](std::string_view part) { text += part; });
  return text;
}

bool read_line(std::istream& stream, std::string& line) {
  stream.exceptions(std::ios::badbit);
  return static_cast<bool>(std::getline(stream, line));
}

TextReader::TextReader(const std::filesystem::path& path)
    : name_(path.string()), size_(readable_size(path)), stream_(open_file(path)) {}

bool TextReader::next_line() {
  try {
    if (!read_line(stream_, line_)) {
      line_.clear();
      return false;
    }
  } catch (const std::ios_base::failure&) {
    fail("the file cannot be read any further");
  }
  ++line_number_;
  if (stream_.eof() && !words().empty())
    fail(
        "the file ends within this line, which has no line end: it may have been cut short; if it is whole, "
        "end it with a newline");
  if (line_number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
  if (line_.ends_with('\r')) line_.pop_back();
  return true;
}

void TextReader::require_line(std::string_view expected) {
  if (!next_line()) fail(fmt::format("the file ends here, but {} must follow", expected));
}

std::vector<std::string_view> TextReader::words(char comment) const {
  std::string_view rest = line_;
  if (comment != '\0') rest = rest.substr(0, rest.find(comment));
  std::vector<std::string_view> found;
  for (std::size_t k = 0; k < rest.size();) {
    if (blank(rest[k])) {
      ++k;
      continue;
    }
    const std::size_t begin = k;
    while (k < rest.size() && !blank(rest[k])) ++k;
    found.push_back(rest.substr(begin, k - begin));
  }
  return found;
}

void TextReader::fail_at(std::int64_t line, std::string_view what) const {
  if (line > 0) throw InputError(fmt::format("{}:{}: {}", name_, line, what));
  throw InputError(fmt::format("{}: {}", name_, what));
}

double TextReader::real(std::string_view word, std::string_view name) const {
  const std::string_view digits = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
    fail(fmt::format("{} is {}; a number is expected", name, quoted(word)));
  if (error == std::errc::result_out_of_range || !std::isfinite(value))
    fail(fmt::format("{} is {}; it must be finite and within double precision", name, quoted(word)));
  return value;
}

double TextReader::positive(std::string_view word, std::string_view name) const {
  const double value = real(word, name);
  if (value <= 0) fail(fmt::format("{} is {}; it must be above zero", name, quoted(word)));
  return value;
}

std::int64_t TextReader::integer(std::string_view word, std::string_view name) const {
  const std::optional<std::int64_t> value = number_in<std::int64_t>(without_plus(word));
  if (!value) fail(fmt::format("{} is {}; a whole number is expected", name, quoted(word)));
  return *value;
}

std::int32_t TextReader::particle_type(std::string_view word) const {
  const std::int64_t value = integer(word, "the type");
  if (value < 1 || value > most_types)
    fail(fmt::format("the type is {}; allowed: 1 to {}", value, most_types));
  return static_cast<std::int32_t>(value);
}

std::int32_t TextReader::image(std::string_view word) const {
  const std::int64_t value = integer(word, "the image");
  constexpr std::int64_t most = 1'000'000'000;
  if (value < -most || value > most) fail("the image is beyond 1e9 cells");
  return static_cast<std::int32_t>(value);
}

std::size_t TextReader::particle_count(std::string_view word, std::size_t least_bytes) const {
  const std::int64_t count = integer(word, "the number of particles");
  if (count < 1) fail(fmt::format("the number of particles is {}; at least 1 is needed", count));
  const auto value = static_cast<std::uint64_t>(count);
  if (value > size_ / least_bytes)
    fail(fmt::format("the number of particles is {}; a file of {} bytes cannot hold them", value, size_));
  if (count > most_particles)
    fail(fmt::format("the number of particles is {}; at most {} can be numbered", count, most_particles));
  return value;
}

}  // namespace furnas
