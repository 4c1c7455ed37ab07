#pragma once

#include <string>
#include <vector>

#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// Error of a conserved quantity, in a compressed gas or a gas in free motion.
struct ConservationError {
  std::string quantity;  ///< "energy ledger", "momentum", "enthalpy"
  std::string law, precision;
  double step{};   ///< [t_c]
  double error{};  ///< of the ledger over the energy put in; of the momentum over sum m abs(v); of
                   ///< the enthalpy over the kinetic energy at the start, root mean square
};

/// Errors in the panel `conservation`: ledger and momentum of a gas that is compressed until contacts slide
/// and the moving cell shears; enthalpy K + U + p_a V + W e^2/2 of a gas without friction and damping under a
/// bath.
std::vector<ConservationError> conservation_errors(Effort effort);

/// Table and charts of these results.
PanelResult panel_of(const std::vector<ConservationError>& errors);

}  // namespace furnas
