#pragma once

#include <array>
#include <cstdint>

#include "engine/analysis/contacts.h"

namespace furnas {

/// The directions of contacts: the mean of n (x) n over contacts (M. Satake, 1982). Its trace is 1.
struct Fabric {
  std::int64_t contacts{};
  std::array<double, 6>
      tensor{};  ///< xx yy zz xy xz yz; 1/3 on the diagonal when isotropic; 0 without contacts

  /// sqrt(3/2) |tensor - 1/3|: 0 when isotropic, 1 when all normals are parallel; F_1 - F_3 when two
  /// eigenvalues are equal. 0 without contacts.
  double anisotropy() const;

  /// Root mean square anisotropy of the same number of random directions, 1/sqrt(contacts).
  double anisotropy_by_chance() const;
};

/// The fabric of these contacts of a packing.
Fabric fabric(const Packing& packing, const Selection& contacts);

}  // namespace furnas
