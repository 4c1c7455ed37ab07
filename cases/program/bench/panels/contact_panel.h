#pragma once

#include <string>
#include <vector>

#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// Errors of enduring contacts, each relative to its closed form.
struct ContactError {
  std::string law;
  double steps{};      ///< in a collision, t_c/dt
  double decay{};      ///< rate of decay of two spheres squeezed between their images, gamma
  double frequency{};  ///< angular frequency of these spheres, (2 k/m_eff - gamma^2)^(1/2)
  double shear{};      ///< C44 of a face-centred crystal with stuck contacts
};

/// Frequency and decay of a contact that stays closed, and the shear modulus of a crystal, against closed
/// forms.
std::vector<ContactError> contact_errors(Effort effort);

/// Table and charts of these results.
PanelResult panel_of(const std::vector<ContactError>& errors);

}  // namespace furnas
