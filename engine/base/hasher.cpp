#include "engine/base/hasher.h"

#define XXH_INLINE_ALL  // only here, because a file that includes hasher.h may itself include xxhash.h
                        // without this macro
#include <xxhash.h>

namespace furnas {

struct Hasher::State {
  XXH3_state_t xxh3;
};

void Hasher::Free::operator()(State* state) const { delete state; }

Hasher::Hasher() : state_(new State) { restart(); }

void Hasher::restart() { XXH3_64bits_reset(&state_->xxh3); }

void Hasher::add_bytes(const void* bytes, std::size_t size) {
  XXH3_64bits_update(&state_->xxh3, bytes, size);
}

std::uint64_t Hasher::value() const { return XXH3_64bits_digest(&state_->xxh3); }

}  // namespace furnas
