#include "cases/program/bench/roofline.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "engine/base/parallel.h"
#include "engine/state/records.h"

namespace furnas {

namespace {

template <class Real, bool spins>
double bytes_moved(double pairs) {
  const std::size_t of_particle = 5 * sizeof(Particle<Real, spins>) + 2 * sizeof(Load<Real, spins>);
  const std::size_t of_pair =
      2 * sizeof(std::uint32_t) + 2 * sizeof(Row<Real, spins>) + (spins ? 2 * sizeof(Spring<Real>) : 0);
  return static_cast<double>(of_particle) + pairs * static_cast<double>(of_pair);
}

}  // namespace

double bytes_per_particle_step(const Traffic& t) {
  if (t.mixed) return t.spins ? bytes_moved<float, true>(t.pairs) : bytes_moved<float, false>(t.pairs);
  return t.spins ? bytes_moved<double, true>(t.pairs) : bytes_moved<double, false>(t.pairs);
}

double triad_bandwidth(int threads, std::size_t bytes) {
  constexpr int passes = 7;
  constexpr std::size_t chunk = std::size_t{1} << 16;
  const std::size_t count = bytes / sizeof(double);
  // The memory is not initialized here, so each page is placed near the thread that first writes to it.
  const auto array = [&] { return std::unique_ptr<double[]>(new double[count]); };
  const auto a = array(), b = array(), c = array();
  double best = 0;
  Workers workers(threads);
  workers.run([&] {
    for_chunks(count, chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
      std::fill(&a[begin], &a[end], 0.0);
      std::fill(&b[begin], &b[end], 1.0);
      std::fill(&c[begin], &c[end], 2.0);
    });
    for (int pass = 0; pass < passes; ++pass) {
      const auto begun = std::chrono::steady_clock::now();
      for_chunks(count, chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t k = begin; k < end; ++k) a[k] = b[k] + 3.0 * c[k];
      });
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begun;
      best = std::max(best, 3 * sizeof(double) * static_cast<double>(count) / time.count());
    }
  });
  return best;
}

std::size_t triad_size() {
  const auto known = [](int name, long otherwise) {
    const long value = ::sysconf(name);
    return static_cast<std::size_t>(value > 0 ? value : otherwise);
  };
  // A virtual machine may report a cache that it shares with many others; arrays above this size exceed any
  // share of it.
  constexpr std::size_t least = std::size_t{64} << 20, most = std::size_t{512} << 20;
  const std::size_t cache = known(_SC_LEVEL3_CACHE_SIZE, 32L << 20);
  const std::size_t available = known(_SC_AVPHYS_PAGES, 1L << 18) * known(_SC_PAGESIZE, 4096);
  return std::min(std::clamp(4 * cache, least, most), available / 8);
}

}  // namespace furnas
