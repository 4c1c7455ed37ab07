#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

/// What libFuzzer calls with every input it thinks of.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const furnas::FuzzTarget& target = furnas::fuzz_target(FURNAS_FUZZ_TARGET);
  target.parse({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
