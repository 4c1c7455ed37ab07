#pragma once

#include <variant>

#include "engine/laws/frictionless.h"
#include "engine/laws/hooke_history.h"
#include "engine/laws/hooke_synchronized.h"

/// The list of the laws. A new law is one line here; phases, kernels, simulation and the tests that every law
/// must pass follow from it. DO gets the law and what else is given.
#define FURNAS_FOR_EACH_LAW(DO, ...)                 \
  DO(HookeSynchronized __VA_OPT__(, ) __VA_ARGS__)   \
  DO(HookeHistory __VA_OPT__(, ) __VA_ARGS__)        \
  DO(Frictionless<false> __VA_OPT__(, ) __VA_ARGS__) \
  DO(Frictionless<true> __VA_OPT__(, ) __VA_ARGS__)

/// DO(law, real) for each law in each precision.
#define FURNAS_FOR_EACH_SCENE(DO) FURNAS_FOR_EACH_LAW(DO, double) FURNAS_FOR_EACH_LAW(DO, float)

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
