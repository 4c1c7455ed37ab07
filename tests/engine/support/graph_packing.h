#pragma once

#include <utility>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Particles of radius 1/2 and mass 1 whose contacts are the edges of a graph, each with a normal force of 1.
/// Places and branches mean nothing: rattlers see the graph alone.
inline Packing packing_of_graph(std::size_t particles, const Edges& edges) {
  Packing p;
  p.cell.edges = {10, 10, 10, 0, 0, 0};
  p.resize(particles);
  for (std::size_t k = 0; k < particles; ++k) p.radius[k] = 0.5, p.mass[k] = 1;
  for (const auto& [i, j] : edges) {
    Contact c;
    c.i = i;
    c.j = j;
    c.branch = {0.9, 0, 0};
    c.overlap = 0.1;
    c.force = {1, 0, 0};
    p.contacts.push_back(c);
  }
  return p;
}

/// Every two of `count` particles from `first` on touch.
inline Edges clique(std::uint32_t count, std::uint32_t first = 0) {
  Edges edges;
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t j = i + 1; j < count; ++j) edges.emplace_back(first + i, first + j);
  return edges;
}

/// Each particle touches the next one.
inline Edges chain(std::uint32_t count, std::uint32_t first = 0) {
  Edges edges;
  for (std::uint32_t i = 0; i + 1 < count; ++i) edges.emplace_back(first + i, first + i + 1);
  return edges;
}

/// The octahedron: six particles, each touches all but the opposite one, so four.
inline Edges octahedron(std::uint32_t first = 0) {
  Edges edges;
  for (std::uint32_t i = 0; i < 6; ++i)
    for (std::uint32_t j = i + 1; j < 6; ++j)
      if (i / 2 != j / 2) edges.emplace_back(first + i, first + j);
  return edges;
}

inline Edges operator+(Edges a, const Edges& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace furnas
