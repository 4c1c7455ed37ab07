#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <numeric>
#include <random>
#include <string>

#include "engine/base/require.h"
#include "engine/state/packing.h"
#include "io/atomic_file.h"

namespace furnas {

/// A folder that is removed with all it holds.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    // In memory where there is such a place: thousands of little files would wait for the disk, one by one.
    const std::filesystem::path memory = "/dev/shm";
    const bool in_memory = ::access(memory.c_str(), W_OK) == 0;
    std::string name =
        ((in_memory ? memory : std::filesystem::temp_directory_path()) / "furnas_test_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

/// While it lives, no file can grow beyond `bytes`, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    struct rlimit little = before_;
    little.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &little);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  struct rlimit before_ {};
};

inline std::string content(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::filesystem::path test_data(const std::string& name) {
  return std::filesystem::path(FURNAS_SOURCE_DIR) / "tests/data" / name;
}

/// Any two-sized packing in a skewed cell, with particles on the cell's faces and far from their first cell.
inline Packing random_packing(unsigned seed, std::size_t count = 40) {
  std::mt19937_64 random(seed);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto vector = [&](double size) {
    return Vec3<double>{real(-size, size), real(-size, size), real(-size, size)};
  };
  Packing p;
  p.step = static_cast<std::int64_t>(random() % 1'000'000'000);
  p.time = real(0, 1e6);
  Triangle& h = p.cell.edges;
  h.xx = real(3, 30), h.yy = real(3, 30), h.zz = real(3, 30);
  h.xy = real(-0.5, 0.5) * h.xx, h.xz = real(-0.5, 0.5) * h.xx, h.yz = real(-0.5, 0.5) * h.yy;
  p.cell.rate = {real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1)};
  p.resize(count);
  const double large_radius = real(0.6, 5);
  for (std::size_t k = 0; k < count; ++k) {
    p.species[k] = k % 5 == 2 ? Species::large : Species::small;
    p.radius[k] = p.species[k] == Species::large ? large_radius : 0.5;
    p.mass[k] = real(0.5, 2) * std::numbers::pi / 6 * 8 * p.radius[k] * p.radius[k] * p.radius[k];
    p.fraction[k] = {random(), random(), random()};
    p.image[k] = {static_cast<int>(random() % 7) - 3, static_cast<int>(random() % 7) - 3, 0};
    p.velocity[k] = vector(1e-3), p.spin[k] = vector(1e-8), p.force[k] = vector(1), p.torque[k] = vector(1e3);
  }
  p.fraction[0] = {0, 1, ~std::uint64_t{0}};
  p.fraction[1] = {~std::uint64_t{0}, std::uint64_t{1} << 63, 0};
  p.velocity[1] = {-0.0, 1e-300, 1e300};
  for (std::uint32_t k = 0; k + 1 < count; k += 2) {
    Contact c;
    c.i = k, c.j = k % 6 == 0 ? k : k + 1;
    c.image = {static_cast<std::int8_t>(random() % 3), -1, 0};
    c.branch = vector(2), c.overlap = real(0, 0.1), c.force = vector(1), c.history = vector(1e-3);
    c.sliding = k % 4 == 0;
    p.contacts.push_back(c);
  }
  p.stress.contacts.setRandom();
  p.stress.motion.setRandom();
  p.order.resize(count);
  std::iota(p.order.begin(), p.order.end(), 0u);
  std::shuffle(p.order.begin(), p.order.end(), random);
  p.ledger = {.initial = real(0, 1),
              .cell_work = real(-1, 1),
              .losses = {real(0, 1), real(0, 1), real(0, 1), real(0, 1)},
              .quenched = real(0, 1),
              .last = {{real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1), real(-1, 1)},
                       {real(0, 1), real(0, 1), real(0, 1), real(0, 1)}}};
  return p;
}

/// Distance of two positions of a particle, modulo the lattice [d_s].
inline double distance(const Packing& a, const Packing& b, std::size_t k) {
  return norm(a.cell.edges * nearest_difference(a.fraction[k], b.fraction[k]));
}

/// The cell, species, sizes, positions and velocities are the same; `size` is that of rounding errors.
inline void expect_same_packing(const Packing& a, const Packing& b, double size = 1e-12) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_NEAR(a.cell.edges.xx, b.cell.edges.xx, size);
  EXPECT_NEAR(a.cell.edges.yy, b.cell.edges.yy, size);
  EXPECT_NEAR(a.cell.edges.zz, b.cell.edges.zz, size);
  EXPECT_EQ(a.cell.edges.xy, b.cell.edges.xy);
  EXPECT_EQ(a.cell.edges.xz, b.cell.edges.xz);
  EXPECT_EQ(a.cell.edges.yz, b.cell.edges.yz);
  EXPECT_EQ(a.species, b.species);
  EXPECT_EQ(a.radius, b.radius);
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_LT(distance(a, b, k), size) << "particle " << k;
    EXPECT_EQ(a.velocity[k], b.velocity[k]) << "particle " << k;
    EXPECT_EQ(a.spin[k], b.spin[k]) << "particle " << k;
  }
}

/// Both packings count the same cells crossed, so that they agree without wrapping.
inline void expect_same_unwrapped(const Packing& a, const Packing& b, double size = 1e-12) {
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_LT(norm(a.unwrapped(k) - b.unwrapped(k)), size) << "particle " << k;
}

/// What an InputError says that `action` throws; empty if it throws none.
template <class Action>
std::string input_error(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A change of a valid text and what the error it causes must say.
struct Damage {
  std::string from, to, message;
};

/// Each change of `text` must be refused with its message, which begins with the file's name.
template <class Read>
void expect_refused(const std::string& text, const std::vector<Damage>& table,
                    const std::filesystem::path& path, Read read) {
  write_file(path, text);
  ASSERT_EQ(input_error([&] { read(path); }), "");
  for (const Damage& damage : table) {
    const std::size_t at = text.find(damage.from);
    ASSERT_NE(at, std::string::npos) << damage.from;
    std::string changed = text;
    write_file(path, changed.replace(at, damage.from.size(), damage.to));
    const std::string message = input_error([&] { read(path); });
    EXPECT_EQ(message.find(path.string()), 0u) << damage.from << " -> " << damage.to << ": " << message;
    EXPECT_NE(message.find(damage.message), std::string::npos)
        << damage.from << " -> " << damage.to << "\n  said     " << message << "\n  expected "
        << damage.message;
  }
}

/// Cut anywhere, a file is refused or (cut after the last number) read; nothing else may happen.
template <class Read>
void expect_no_crash_when_cut(const std::string& bytes, const std::filesystem::path& path, Read read,
                              std::size_t stride = 1) {
  for (std::size_t length = 0; length < bytes.size(); length += stride) {
    std::ofstream(path, std::ios::binary) << bytes.substr(0, length);
    input_error([&] { read(path); });
  }
}

}  // namespace furnas
