#include "engine/kernels/kernels.h"

#include <hwy/targets.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string>

#include "engine/base/require.h"

namespace furnas {

#ifdef __x86_64__
#define FURNAS_FOR_EACH_SET(DO) DO(scalar) DO(avx2) DO(avx512)
#else
#define FURNAS_FOR_EACH_SET(DO) DO(scalar)
#endif

// The kernels of each set are defined in engine/kernels/all_kernels.cpp, which is compiled once for each set.
#define FURNAS_DECLARE(set)     \
  namespace kernels_for_##set { \
    template <class S>          \
    Kernels<S> kernels();       \
  }
FURNAS_FOR_EACH_SET(FURNAS_DECLARE)
#undef FURNAS_DECLARE

namespace {

InstructionSet best_set() {
#ifdef __x86_64__
  const std::int64_t supported = hwy::SupportedTargets();
  if (supported & HWY_AVX3) return InstructionSet::avx512;
  if (supported & HWY_AVX2) return InstructionSet::avx2;
#endif
  return InstructionSet::scalar;
}

InstructionSet first_choice() {
  const char* wanted = std::getenv("FURNAS_SIMD");
  if (wanted == nullptr) return best_set();
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512})
    if (std::string(wanted) == to_string(set)) return std::min(set, best_set());
  throw InputError("FURNAS_SIMD = \"" + std::string(wanted) + "\"; allowed: scalar, AVX2, AVX-512");
}

std::atomic<InstructionSet>& chosen() {
  static std::atomic<InstructionSet> set = first_choice();
  return set;
}

}  // namespace

const char* to_string(InstructionSet set) {
  switch (set) {
    case InstructionSet::scalar:
      return "scalar";
    case InstructionSet::avx2:
      return "AVX2";
    case InstructionSet::avx512:
      return "AVX-512";
  }
  return "";
}

InstructionSet instruction_set() { return chosen(); }

void choose(InstructionSet set) { chosen() = std::min(set, best_set()); }

template <class S>
const Kernels<S>& kernels() {
#define FURNAS_TABLE(set) kernels_for_##set::kernels<S>(),
  static const Kernels<S> table[] = {FURNAS_FOR_EACH_SET(FURNAS_TABLE)};
#undef FURNAS_TABLE
  return table[static_cast<std::size_t>(instruction_set())];
}

#define FURNAS_INSTANTIATE(Law, Real) \
  template const Kernels<Numerics<Law, Real>>& kernels<Numerics<Law, Real>>();
FURNAS_FOR_EACH_NUMERICS(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
