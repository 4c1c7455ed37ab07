#include "engine/structure/furnas_model.h"

#include <algorithm>

namespace furnas {

double FurnasModel::phi(double f) const {
  // The denominators cross at f_max alone, and the larger one belongs to the branch that holds.
  return mono / std::max(1 - f, f + mono * (1 - f));
}

double fraction_of_large(double phi, double f) { return phi * (1 - f); }

double fraction_in_voids(double phi, double f) { return f * phi / (1 - phi * (1 - f)); }

}  // namespace furnas
