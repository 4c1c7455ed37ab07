#pragma once

#include <cstddef>
#include <vector>

#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// Differences between the contact forces of a step and a calculation in long double.
struct ForceError {
  std::size_t contacts{};  ///< of the packing, from the calculation in long double
  std::size_t missed{};    ///< of these, missing in the step
  std::size_t spurious{};  ///< contacts of the step that the packing does not have
  double median{};         ///< median of |difference|/|force| over the contacts that both have
  double largest{};        ///< largest |difference|/(mean |force|) of these contacts

  /// Number of missed and spurious contacts over the number of contacts.
  double mistaken() const {
    return contacts ? static_cast<double>(missed + spurious) / static_cast<double>(contacts) : 0;
  }
};

/// Compares i, j, branch and force of the `contacts` of a packing with those of a second calculation in long
/// double, without history. The second calculation finds contacts with the certificate's search, which shares
/// no code with the engine's, and has its own code for the formulas of the laws.
ForceError force_error(const AnyLaw& law, const Packing& packing, const std::vector<Contact>& contacts);

/// The same for the contacts of a simulation that begins with the positions and velocities of `packing`.
ForceError force_error(const Model& model, const Packing& packing, int threads = 1);

}  // namespace furnas
