#pragma once

#include <variant>

#include "engine/laws/frictionless.h"
#include "engine/laws/hooke_history.h"
#include "engine/laws/hooke_synchronized.h"

/// The list of the laws. A new law needs one line here. Phases, kernels, the simulation and the tests that
/// every law must pass are instantiated from this list. DO is called with the law and the further arguments.
#define FURNAS_FOR_EACH_LAW(DO, ...)                 \
  DO(HookeSynchronized __VA_OPT__(, ) __VA_ARGS__)   \
  DO(HookeHistory __VA_OPT__(, ) __VA_ARGS__)        \
  DO(Frictionless<false> __VA_OPT__(, ) __VA_ARGS__) \
  DO(Frictionless<true> __VA_OPT__(, ) __VA_ARGS__)

/// DO(law, real) for each law in each precision.
#define FURNAS_FOR_EACH_NUMERICS(DO) FURNAS_FOR_EACH_LAW(DO, double) FURNAS_FOR_EACH_LAW(DO, float)

namespace furnas {

namespace detail {
template <class First, class... Laws>
using VariantOf = std::variant<Laws...>;
}

#define FURNAS_COMMA_LAW(Law) , Law
/// One of the laws on the list, with its constants.
using AnyLaw = detail::VariantOf<void FURNAS_FOR_EACH_LAW(FURNAS_COMMA_LAW)>;
#undef FURNAS_COMMA_LAW

/// The constants of a law.
inline const HookeConstants& constants_of(const AnyLaw& any) {
  return std::visit([](const auto& law) -> const HookeConstants& { return law.constants; }, any);
}

/// Whether particles rotate and contacts have histories under a law.
inline bool has_friction(const AnyLaw& any) {
  return std::visit([](const auto& law) { return law.spins; }, any);
}

/// Whether the lever arms of a law end in the middle of the overlap; otherwise they are the full radii.
inline bool arms_meet(const AnyLaw& any) {
  return std::visit([](const auto& law) { return law.arms_meet; }, any);
}

/// Whether dashpots use velocities predicted for the end of the step, otherwise those of its middle, and the
/// history of a contact turns with its spheres about the normal.
inline bool is_synchronized(const AnyLaw& any) {
  return std::visit([](const auto& law) { return law.synchronized; }, any);
}

/// Push, stiffness and damping of a contact under a law.
inline ContactStiffness stiffness_of(const AnyLaw& any, const Touch<double>& touch) {
  return std::visit([&](const auto& law) { return law.stiffness(touch); }, any);
}

/// Energy of a contact under a law.
inline ContactEnergy energy_of(const AnyLaw& any, const Touch<double>& touch, const Vec3<double>& history) {
  return std::visit([&](const auto& law) { return law.energy(touch, history); }, any);
}

}  // namespace furnas
