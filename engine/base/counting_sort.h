#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/base/refill.h"

namespace furnas {

/// Sorts the numbers below `count` by key(n) < `keys`. The numbers with key k get the places
/// [first[k], first[k + 1]), in any order; `first` is filled anew. Calls put(place, n) for each number, on
/// several threads.
template <class Key, class Put>
void counting_sort(std::size_t count, std::size_t keys, std::vector<std::uint32_t>& first, Key&& key,
                   Put&& put) {
  constexpr std::size_t chunk = 1024;
  const auto first_of = [&](std::size_t n) { return std::atomic_ref(first[key(n)]); };
  refill(first, keys + 1, std::uint32_t{0});
  for_chunks(count, chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t n = begin; n < end; ++n) first_of(n).fetch_add(1, std::memory_order_relaxed);
  });
  // Each key is filled from its last place, so that first[k] moves from the end to the beginning.
  std::partial_sum(first.begin(), first.end(), first.begin());
  for_chunks(count, chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t n = begin; n < end; ++n) put(first_of(n).fetch_sub(1, std::memory_order_relaxed) - 1, n);
  });
}

}  // namespace furnas
