#pragma once

#include <cstddef>
#include <vector>

#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// How far the forces of the step are from those of the packing in long double.
struct ForceError {
  std::size_t contacts{};  ///< of the packing
  std::size_t missed{};    ///< of these, unknown to the step
  std::size_t spurious{};  ///< contacts of the step that the packing does not have
  double median{};         ///< |difference|/|force| of the contacts that both have
  double largest{};        ///< |difference|/(mean |force|) of the worst of them

  /// Missed and spurious contacts over the contacts.
  double mistaken() const {
    return contacts ? static_cast<double>(missed + spurious) / static_cast<double>(contacts) : 0;
  }
};

/// Compares `contacts` of a packing, of which i, j, branch and force count, with those of a second
/// calculation in long double, without history. That finds them with the certificate's search, which shares
/// no code with the engine's, and has the formulas of the laws written anew.
ForceError force_error(const AnyLaw& law, const Packing& packing, const std::vector<Contact>& contacts);

/// The same for the contacts of a simulation that begins with the positions and velocities of `packing`.
ForceError force_error(const Model& model, const Packing& packing, int threads = 1);

}  // namespace furnas
