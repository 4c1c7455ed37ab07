#pragma once

#include "engine/model.h"
#include "engine/start/replicate.h"
#include "io/lammps_data.h"

namespace furnas {

/// 500 equal spheres at the density of a jammed packing, in motion, repeated.
inline Packing mono(const Times& times) {
  return replicate(read_lammps_data(FURNAS_SOURCE_DIR "/tests/data/mono.data"), times);
}

/// 4000 of them.
inline const Packing& dense_packing() {
  static const Packing packing = mono({2, 2, 2});
  return packing;
}

/// A law with the constants of the paper, in a cell that may deform.
inline Model model_with(const AnyLaw& law) {
  Model model;
  model.law = law;
  model.barostat.inertia = 1e6;
  return model;
}

}  // namespace furnas
