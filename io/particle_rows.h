#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/state/packing.h"
#include "io/file_cell.h"
#include "io/text_reader.h"

namespace furnas {

/// One particle as a line of a text file gives it.
struct ParticleRow {
  std::int64_t id{};        ///< any whole number, once in a file
  std::int64_t line{};      ///< where it stands in the file
  std::int32_t type{};      ///< 1 or more; 0: the file has none
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

/// The types of a file that names them by words, as they come.
class NamedTypes {
 public:
  /// Notes the name of the row's type. A row without a type gets a number that counts until finish().
  void note(std::string_view name, ParticleRow& row);
  /// The names of the types 1, 2, ... Where the rows had no types they get them: "large" is 1 and "small" 2
  /// where there are no others; whole numbers stand for themselves and have no names; else 1, 2 ... in the
  /// order of the alphabet.
  std::vector<std::string> finish(std::vector<ParticleRow>& rows) const;

 private:
  std::vector<std::string> names_of_numbers() const;

  std::map<std::string, std::int32_t, std::less<>> known_;  ///< of rows without a type
  std::map<std::int32_t, std::string> numbered_;            ///< of rows with one
};

/// The packing of these particles in order of id, with the species of their types (species_by_type), or of
/// the names of these where they are "large" and "small". Throws InputError for an id that occurs twice and
/// for a particle farther away than an image can count.
Packing assemble(const TextReader& reader, const FileCell& cell, std::vector<ParticleRow> rows,
                 std::vector<std::string> names = {});

/// Gives a packing species and labels by the types of its particles, 1 or more, and the names of the types,
/// which count where no two are the same. Without types: by sizes.
void label_by_types(Packing& packing, std::vector<std::int32_t> types, std::vector<std::string> names);

/// Keeps the types and their names in the labels of a packing that has its species, unless they say no more
/// than these.
void keep_types(Packing& packing, std::vector<std::int32_t> types, std::vector<std::string> names);

/// Throws InputError that names `file` unless the packing is sound (flaw_of).
void check_packing(const Packing& packing, const std::filesystem::path& file);

}  // namespace furnas
