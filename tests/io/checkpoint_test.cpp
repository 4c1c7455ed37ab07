#include "io/checkpoint.h"

#include <bit>
#include <cmath>
#include <limits>

#include "engine/state/fingerprint.h"
#include "tests/engine/support/same_packing.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

Checkpoint example(unsigned seed, std::size_t count) {
  return {random_packing(seed, count),
          "[mixture]\nsize_ratio = 5.0\n",
          {{"schedule", std::string("\0\1\2", 3)}, {"", "x"}}};
}

TEST(ReliableCheckpoint, KeepsEveryBit) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Checkpoint a = example(seed, seed == 0 ? 60'000 : 10 * seed);  // 60 000: several blocks
    write_checkpoint(a, folder / "a");
    const Checkpoint b = read_checkpoint(folder / "a");
    EXPECT_TRUE(test::same_packing(a.packing, b.packing));
    EXPECT_EQ(state_hash(a.packing), state_hash(b.packing));
    EXPECT_EQ(a.case_text, b.case_text);
    EXPECT_EQ(a.extras, b.extras);
    EXPECT_EQ(folder.files(), 1u);
  }
}

TEST(ReliableCheckpoint, NeedsNoContactsOrderOrExtras) {
  const TemporaryFolder folder;
  Checkpoint a{random_packing(1), "", {}};
  a.packing.contacts.clear();
  a.packing.order.clear();
  write_checkpoint(a, folder / "a");
  const Checkpoint b = read_checkpoint(folder / "a");
  EXPECT_TRUE(test::same_packing(a.packing, b.packing));
  EXPECT_TRUE(b.extras.empty() && b.case_text.empty());
}

TEST(ReliableCheckpoint, EveryChangedByteIsNoticed) {
  const TemporaryFolder folder;
  write_checkpoint(example(2, 8), folder / "a");
  const std::string bytes = content(folder / "a");
  std::mt19937_64 random(1);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
    std::ofstream(folder / "b", std::ios::binary) << changed;
    const std::string message = input_error([&] { read_checkpoint(folder / "b"); });
    ASSERT_TRUE(message.starts_with((folder / "b").string() + ": ")) << "byte " << at << ": " << message;
    if (at >= 16 && at < bytes.size() - 32) {
      EXPECT_NE(message.find("section '"), std::string::npos) << message;
    }
  }
}

TEST(ReliableCheckpoint, EveryCutIsNoticed) {
  const TemporaryFolder folder;
  write_checkpoint(example(3, 8), folder / "a");
  const std::string bytes = content(folder / "a");
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    std::ofstream(folder / "b", std::ios::binary) << bytes.substr(0, length);
    ASSERT_NE(input_error([&] { read_checkpoint(folder / "b"); }), "") << length;
  }
  std::ofstream(folder / "b", std::ios::binary) << bytes << 'x';
  EXPECT_NE(input_error([&] { read_checkpoint(folder / "b"); }), "");
}

TEST(ReliableCheckpoint, DamageInASectionNamesIt) {
  const TemporaryFolder folder;
  write_checkpoint(example(4, 500), folder / "a");
  std::string bytes = content(folder / "a");
  const std::size_t at = bytes.find("velocity");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 100] = static_cast<char>(bytes[at + 100] ^ 1);
  std::ofstream(folder / "b", std::ios::binary) << bytes;
  EXPECT_NE(input_error([&] { read_checkpoint(folder / "b"); }).find("section 'velocity': damaged"),
            std::string::npos);
}

TEST(ReliableCheckpoint, SwappedSectionsAreNoticed) {
  const TemporaryFolder folder;
  write_checkpoint(example(9, 30), folder / "a");
  const std::string bytes = content(folder / "a");
  const auto begin = [&](const char* section) {
    return bytes.find(section) - 16;
  };  // its head is before its name
  const std::size_t velocity = begin("velocity"), spin = begin("spin"), force = begin("force");
  std::ofstream(folder / "b", std::ios::binary)
      << bytes.substr(0, velocity) + bytes.substr(spin, force - spin) +
             bytes.substr(velocity, spin - velocity) + bytes.substr(force);
  EXPECT_NE(input_error([&] { read_checkpoint(folder / "b"); }).find("section 'velocity': damaged"),
            std::string::npos);
}

/// A large one, cut at every page as a disk might, and with bits turned over anywhere.
TEST(ReliableCheckpoint, DamageToALargeOneIsNoticed) {
  const TemporaryFolder folder;
  write_checkpoint(example(10, 5000), folder / "a");
  const std::string bytes = content(folder / "a");
  for (std::size_t length = 0; length < bytes.size(); length += 4096) {
    std::ofstream(folder / "b", std::ios::binary) << bytes.substr(0, length);
    ASSERT_NE(input_error([&] { read_checkpoint(folder / "b"); }), "") << length;
  }
  std::mt19937_64 random(2);
  for (int n = 0; n < 300; ++n) {
    std::string changed = bytes;
    char& byte = changed[random() % changed.size()];
    byte = static_cast<char>(byte ^ (1 << random() % 8));
    std::ofstream(folder / "b", std::ios::binary) << changed;
    ASSERT_NE(input_error([&] { read_checkpoint(folder / "b"); }), "");
  }
}

/// A count of elements that nothing backs must not be believed, whatever it is.
TEST(ReliableCheckpoint, HugeCountsAllocateNothing) {
  const TemporaryFolder folder;
  write_checkpoint(example(5, 20), folder / "a");
  const std::string bytes = content(folder / "a");
  for (const std::uint64_t count : {std::uint64_t{1} << 40, ~std::uint64_t{0}, ~std::uint64_t{0} / 8}) {
    std::string changed = bytes;
    std::memcpy(changed.data() + bytes.find("radius") - 8, &count, 8);
    std::ofstream(folder / "b", std::ios::binary) << changed;
    EXPECT_NE(input_error([&] { read_checkpoint(folder / "b"); }).find("section 'radius'"),
              std::string::npos);
  }
}

TEST(ReliableCheckpoint, WhatIsNoPackingIsRefused) {
  const TemporaryFolder folder;
  const auto message = [&](auto change) {
    Checkpoint a = example(6, 20);
    change(a.packing);
    write_checkpoint(a, folder / "a");
    return input_error([&] { read_checkpoint(folder / "a"); });
  };
  const auto names = [](const std::string& text, const char* what) {
    return text.find(what) != std::string::npos;
  };
  EXPECT_TRUE(names(message([](Packing& p) { p.spin.pop_back(); }), "section 'spin'"));
  EXPECT_TRUE(names(message([](Packing& p) { p.order[3] = p.order[4]; }), "section 'order'"));
  EXPECT_TRUE(names(message([](Packing& p) { p.order.pop_back(); }), "section 'order'"));
  EXPECT_TRUE(
      names(message([](Packing& p) { p.species[2] = static_cast<Species>(7); }), "section 'species'"));
  EXPECT_TRUE(names(message([](Packing& p) { p.contacts[1].j = 20; }), "contact"));
  EXPECT_TRUE(names(message([](Packing& p) { p.velocity[7].x = std::nan(""); }), "particle 8"));
  EXPECT_TRUE(names(message([](Packing& p) { p.cell.edges.zz = 0; }), "cell"));
}

TEST(ReliableCheckpoint, NamesAnotherVersion) {
  const TemporaryFolder folder;
  write_checkpoint(example(7, 8), folder / "a");
  std::string bytes = content(folder / "a");
  bytes[8] = 9;
  std::ofstream(folder / "b", std::ios::binary) << bytes;
  EXPECT_NE(input_error([&] { read_checkpoint(folder / "b"); }).find("another version"), std::string::npos);
}

TEST(ReliableCheckpoint, AFailedWriteLeavesTheOldOne) {
  const TemporaryFolder folder;
  write_checkpoint(example(8, 8), folder / "a");
  const std::string before = content(folder / "a");
  {
    const FullDisk full(10'000);
    EXPECT_THROW(write_checkpoint(example(9, 1000), folder / "a"), OutputError);
  }
  EXPECT_EQ(content(folder / "a"), before);
  EXPECT_EQ(folder.files(), 1u);
  EXPECT_THROW(write_checkpoint(example(8, 8), folder / "none/a"), OutputError);
}

TEST(ReliableCheckpoint, IsKnownByItsFirstBytes) {
  const TemporaryFolder folder;
  write_checkpoint({random_packing(1), "", {}}, folder / "a");
  EXPECT_TRUE(is_checkpoint(folder / "a"));
  write_file(folder / "b", "FURNASC");
  EXPECT_FALSE(is_checkpoint(folder / "b"));
  EXPECT_FALSE(is_checkpoint(folder / "none"));
  EXPECT_FALSE(is_checkpoint((folder / "a").parent_path()));
}

}  // namespace
}  // namespace furnas
