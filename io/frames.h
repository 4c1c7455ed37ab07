#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <utility>

#include "engine/state/packing.h"

namespace furnas {

/// The frame of this number, counted from 1, or the last. The reader's next() returns one frame after the
/// other, and an empty value at the end. Throws InputError if there is no frame of that number.
template <class Reader>
Packing chosen_frame(Reader& reader, std::optional<std::int64_t> wanted) {
  std::optional<Packing> last;
  std::int64_t count = 0;
  for (auto frame = reader.next(); frame; frame = reader.next()) {
    last = std::move(frame);
    if (++count == wanted) return std::move(*last);
  }
  if (!last) reader.fail("there is no frame in it");
  if (wanted) reader.fail(fmt::format("there is no frame {}; allowed: 1 to {}", *wanted, count));
  return std::move(*last);
}

}  // namespace furnas
