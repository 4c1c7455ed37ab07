#include "io/section_file.h"

#include <fmt/format.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <new>

#include "engine/base/require.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

constexpr std::size_t magic_size = 8;
constexpr std::size_t head_size = 16;
constexpr std::size_t trailer_size = 32;
constexpr std::uint32_t longest_name = 64;
constexpr int compression_level = 1;  // positions and forces hardly shrink at any level

/// A fuzzer cannot guess hashes. Without hash checks it reaches the code behind them.
#ifdef FURNAS_FUZZING
constexpr bool hashes_count = false;
#else
constexpr bool hashes_count = true;
#endif

/// The numbers before the name of a section.
struct SectionHead {
  std::uint32_t name_length{}, element_size{};
  std::uint64_t count{};
};
static_assert(sizeof(SectionHead) == 16);

/// The numbers before a zstd frame.
struct BlockHead {
  std::uint32_t raw_size{}, stored_size{};
};
static_assert(sizeof(BlockHead) == 8);

/// zstd allocates memory itself. A lack of memory must not be reported as a damaged file.
void refuse_without_memory(std::size_t zstd_answer) {
  if (ZSTD_getErrorCode(zstd_answer) == ZSTD_error_memory_allocation) throw std::bad_alloc();
}

std::array<char, head_size> file_head(const SectionFormat& format) {
  require(format.magic.size() == magic_size, "the magic of a section file has 8 characters");
  std::array<char, head_size> head{};
  std::memcpy(head.data(), format.magic.data(), magic_size);
  std::memcpy(head.data() + magic_size, &format.version, sizeof format.version);
  return head;
}

}  // namespace

SectionWriter::SectionWriter(const std::filesystem::path& path, const SectionFormat& format)
    : file_(path), format_(format) {
  const auto head = file_head(format);
  put(head.data(), head.size());
  file_hash_.add(head);
}

void SectionWriter::put(const void* bytes, std::size_t size) {
  file_.write({static_cast<const char*>(bytes), size});
  section_hash_.add_bytes(bytes, size);
  size_ += size;
}

void SectionWriter::begin(std::string_view name, std::size_t element_size, std::size_t count) {
  require(name.size() <= longest_name, "the name of a section is too long");
  const SectionHead head{static_cast<std::uint32_t>(name.size()), static_cast<std::uint32_t>(element_size),
                         count};
  section_hash_.restart();
  put(&head, sizeof head);
  put(name.data(), name.size());
}

void SectionWriter::add_block(const void* raw, std::size_t size) {
  frame_.resize(ZSTD_compressBound(size));
  const std::size_t stored = ZSTD_compress(frame_.data(), frame_.size(), raw, size, compression_level);
  refuse_without_memory(stored);
  require(!ZSTD_isError(stored), "zstd compresses a block into a buffer of the size it asked for");
  const BlockHead head{static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(stored)};
  put(&head, sizeof head);
  put(frame_.data(), stored);
  section_hash_.add_bytes(raw, size);
}

void SectionWriter::end() {
  const std::uint64_t hash = section_hash_.value();
  put(&hash, sizeof hash);
  file_hash_.add(hash);
  ++sections_;
}

void SectionWriter::commit() {
  const std::array<std::uint64_t, 2> sums{sections_, size_ + trailer_size};
  file_hash_.add(sums);
  const std::uint64_t hash = file_hash_.value();
  put(sums.data(), sizeof sums);
  put(&hash, sizeof hash);
  put(format_.magic.data(), magic_size);
  file_.commit();
}

SectionReader::SectionReader(const std::filesystem::path& path, const SectionFormat& format)
    : name_(path.string()), remaining_(readable_size(path)), stream_(open_file(path)) {
  const std::uint64_t size = remaining_;
  const auto refuse = [&](std::string_view what) { throw InputError(fmt::format("{}: {}", name_, what)); };
  std::array<char, head_size> head{};
  std::array<char, trailer_size> tail{};
  if (size < head_size + trailer_size) refuse("too short to be complete");
  stream_.read(head.data(), head_size);
  stream_.seekg(-static_cast<std::streamoff>(trailer_size), std::ios::end);
  stream_.read(tail.data(), trailer_size);
  stream_.seekg(head_size);
  if (!stream_) refuse("cannot be read");

  const auto expected = file_head(format);
  if (!std::equal(expected.begin(), expected.begin() + magic_size, head.begin()))
    refuse(fmt::format("not in this format: the file does not begin with {}", format.magic));
  if (head != expected)
    refuse(fmt::format("written in another version of this format; this program reads version {}",
                       format.version));
  std::memcpy(trailer_.data(), tail.data(), sizeof trailer_);
  if (!std::equal(format.magic.begin(), format.magic.end(), tail.begin() + sizeof trailer_) ||
      trailer_[1] != size)
    refuse("damaged in the trailer, or not complete");
  remaining_ = size - head_size - trailer_size;
  file_hash_.add(head);
}

void SectionReader::fail(std::string_view what) const {
  throw InputError(fmt::format("{}: section '{}': {}", name_, section_, what));
}

void SectionReader::get(void* bytes, std::size_t size) {
  if (size > remaining_) fail("damaged: it reaches beyond the end of the file");
  if (!stream_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size))) fail("cannot be read");
  remaining_ -= size;
  section_hash_.add_bytes(bytes, size);
}

void SectionReader::begin(std::string_view name, std::size_t element_size) {
  section_ = name;
  section_hash_.restart();
  SectionHead head;
  get(&head, sizeof head);
  if (head.name_length > longest_name) fail("damaged: another section is here, or none");
  std::string found(head.name_length, '\0');
  get(found.data(), found.size());
  if (found != name || head.element_size != element_size) fail("damaged: another section is here, or none");
  element_size_ = element_size;
  elements_left_ = head.count;
}

std::span<const char> SectionReader::next_block() {
  if (elements_left_ == 0) return {};
  const std::uint64_t elements = std::min<std::uint64_t>(block_size / element_size_, elements_left_);
  const std::size_t size = static_cast<std::size_t>(elements) * element_size_;
  BlockHead head;
  get(&head, sizeof head);
  if (head.raw_size != size || head.stored_size > ZSTD_compressBound(size) || head.stored_size > remaining_)
    fail("damaged: a block has a wrong size");
  frame_.resize(head.stored_size);
  raw_.resize(size);
  get(frame_.data(), frame_.size());
  const std::size_t got = ZSTD_decompress(raw_.data(), size, frame_.data(), frame_.size());
  refuse_without_memory(got);
  if (got != size || ZSTD_getFrameContentSize(frame_.data(), frame_.size()) != size)
    fail("damaged: a block cannot be decompressed");
  section_hash_.add_bytes(raw_.data(), size);
  elements_left_ -= elements;
  return raw_;
}

void SectionReader::end() {
  const std::uint64_t expected = section_hash_.value();
  std::uint64_t hash = 0;
  get(&hash, sizeof hash);
  if (hashes_count && hash != expected) fail("damaged: its hash does not fit");
  file_hash_.add(hash);
  ++sections_;
}

void SectionReader::finish() {
  section_ = "trailer";
  if (remaining_ != 0 || sections_ != trailer_[0]) fail("damaged: there are more sections than expected");
  file_hash_.add(std::array<std::uint64_t, 2>{trailer_[0], trailer_[1]});
  if (hashes_count && file_hash_.value() != trailer_[2]) fail("damaged: the hash over the file does not fit");
}

}  // namespace furnas
