#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <type_traits>

#include "engine/laws/any_law.h"

namespace furnas {

namespace detail {
template <class Law>
using OnlyIfSpins = std::conditional_t<Law::spins, std::tuple<Law>, std::tuple<>>;

template <class Tuple>
struct AsTypes;
template <class... Laws>
struct AsTypes<std::tuple<Laws...>> {
  using Type = testing::Types<Laws...>;
};

template <class Variant>
struct LawsOf;
template <class... Laws>
struct LawsOf<std::variant<Laws...>> {
  using Every = testing::Types<Laws...>;
  using WithFriction = typename AsTypes<decltype(std::tuple_cat(std::declval<OnlyIfSpins<Laws>>()...))>::Type;
};
}  // namespace detail

/// All laws on the list, and those that know friction, for typed tests.
using EveryLaw = detail::LawsOf<AnyLaw>::Every;
using EveryFrictionLaw = detail::LawsOf<AnyLaw>::WithFriction;

/// A friction that no contact reaches.
constexpr double no_sliding = 1e30;

struct LawName {
  template <class Law>
  static std::string GetName(int) {  // NOLINT(readability-identifier-naming): GoogleTest calls it
    std::string name(Law::name);
    if (!Law::spins) name += "_frictionless";
    return name;
  }
};

}  // namespace furnas
