#pragma once

#include "tests/engine/support/compaction.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas::test {

/// A packing, and the model that it moves by.
struct HotGas {
  Packing start;
  Model model;
};

/// A hot gas of few spheres in any cell, under strain; of speeds up to 2 `violence` and rates up to 0.2
/// `violence`.
inline HotGas hot_gas(Dice& dice, double violence) {
  RandomPacking wanted;
  wanted.size_ratio = *rc::gen::element(1, 3, 10);
  wanted.large = *rc::gen::inRange<std::size_t>(1, 3);
  wanted.small = *rc::gen::inRange<std::size_t>(1, 40);
  wanted.cell = wanted.size_ratio * dice.between(0.8, 6);
  wanted.speed = dice.between(0, 2 * violence);
  HotGas gas{random_packing(dice, wanted), hasty_model(dice.chance(0.5) ? 0.3 : 0)};
  const double strain = dice.between(0, 0.2 * violence);
  const auto rate = [&] { return dice.between(-strain, strain); };
  gas.start.cell.rate = {rate(), rate(), rate(), rate(), rate(), rate()};
  gas.model.barostat.inertia = 1e4 * wanted.size_ratio * wanted.size_ratio;
  return gas;
}

}  // namespace furnas::test
