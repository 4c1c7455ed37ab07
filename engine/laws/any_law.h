#pragma once

#include <variant>

#include "engine/laws/frictionless.h"
#include "engine/laws/hooke_history.h"
#include "engine/laws/hooke_synchronized.h"

/// The list of the laws. A new law is one line here; phases, simulation and the tests that every law
/// must pass follow from it.
#define FURNAS_FOR_EACH_LAW(DO) \
  DO(HookeSynchronized)         \
  DO(HookeHistory)              \
  DO(Frictionless<false>)       \
  DO(Frictionless<true>)

namespace furnas {

namespace detail {
template <class First, class... Laws>
using VariantOf = std::variant<Laws...>;
}

#define FURNAS_COMMA_LAW(Law) , Law
/// One of the laws on the list, with its constants.
using AnyLaw = detail::VariantOf<void FURNAS_FOR_EACH_LAW(FURNAS_COMMA_LAW)>;
#undef FURNAS_COMMA_LAW

}  // namespace furnas
