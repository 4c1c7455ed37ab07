#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/state/packing.h"
#include "io/text_reader.h"

namespace furnas {

/// One particle as a line of a text file gives it.
struct ParticleRow {
  std::int64_t id{};        ///< any whole number, once in a file
  std::int64_t line{};      ///< where it stands in the file
  double radius{};          ///< [d_s]
  double mass{};            ///< [rho d_s^3]
  Vec3<double> place;       ///< position in units of the cell's edges, from its origin; not wrapped
  Image image{};            ///< cells crossed in addition to those in `place`
  Vec3<double> velocity{};  ///< peculiar [d_s/time]
  Vec3<double> spin{};      ///< [1/time]
  Vec3<double> force{};     ///< [k_n d_s]
  Vec3<double> torque{};    ///< [k_n d_s^2]
};

/// A Cartesian vector [d_s] in units of the cell's edges.
Vec3<double> in_edges(const Triangle& edges, const Vec3<double>& v);

/// Throws InputError at the reader's line unless the edges span a cell.
void check_edges(const TextReader& reader, const Triangle& edges);

/// Puts a position in units of the edges, wherever it lies, into the cell and counts the crossings into
/// `image`; false if there are more than an image can count.
bool wrap(const Vec3<double>& place, Fraction& fraction, Image& image);

/// The packing of these particles in order of id; throws InputError for an id that occurs twice and for a
/// particle farther away than an image can count.
Packing assemble(const TextReader& reader, const Triangle& edges, std::vector<ParticleRow> rows);

/// Throws InputError that names `file` unless the packing is sound (flaw_of).
void check_packing(const Packing& packing, const std::filesystem::path& file);

}  // namespace furnas
