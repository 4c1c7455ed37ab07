#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <type_traits>

#include "engine/laws/any_law.h"

namespace furnas {

namespace detail {
template <class Law>
using only_if_spins = std::conditional_t<Law::spins, std::tuple<Law>, std::tuple<>>;

template <class Tuple>
struct as_types;
template <class... Laws>
struct as_types<std::tuple<Laws...>> {
  using type = testing::Types<Laws...>;
};

template <class Variant>
struct laws_of;
template <class... Laws>
struct laws_of<std::variant<Laws...>> {
  using every = testing::Types<Laws...>;
  using with_friction =
      typename as_types<decltype(std::tuple_cat(std::declval<only_if_spins<Laws>>()...))>::type;
};
}  // namespace detail

/// All laws on the list, and those that know friction, for typed tests.
using EveryLaw = detail::laws_of<AnyLaw>::every;
using EveryFrictionLaw = detail::laws_of<AnyLaw>::with_friction;

/// A friction that no contact reaches.
constexpr double no_sliding = 1e30;

struct LawName {
  template <class Law>
  static std::string GetName(int) {
    return std::string(Law::name) + (Law::spins ? "" : "_frictionless");
  }
};

}  // namespace furnas
