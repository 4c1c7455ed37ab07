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
  std::int64_t id{};        ///< any whole number, unique in a file
  std::int64_t line{};      ///< its line number in the file
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

/// Wraps a position, in units of the edges, into the cell and adds the crossed cells to `image`; false if
/// there are more than an image can count.
bool wrap(const Vec3<double>& place, Fraction& fraction, Image& image);

/// Collects the types of a file that names types by words.
class NamedTypes {
 public:
  /// Records the name of the row's type. A row without a type gets a provisional number, which finish()
  /// replaces.
  void note(std::string_view name, ParticleRow& row);
  /// Returns the names of the types 1, 2, ... and gives types to rows that had none. If all names are "large"
  /// or "small", these become the types 1 and 2. If all names are whole numbers, these numbers become the
  /// types, which then have no names. Otherwise the names are numbered 1, 2, ... in alphabetical order.
  std::vector<std::string> finish(std::vector<ParticleRow>& rows) const;

 private:
  std::vector<std::string> names_of_numbers() const;

  std::map<std::string, std::int32_t, std::less<>> known_;  ///< names of rows without a type
  std::map<std::int32_t, std::string> numbered_;            ///< names of rows with a type
};

/// The packing of these particles in the order of their ids. Their species follow from the names of the types
/// where these are "large" and "small", and otherwise from the types (species_by_type). Throws InputError for
/// an id that occurs twice and for a particle farther away than an image can count.
Packing assemble(const TextReader& reader, const FileCell& cell, std::vector<ParticleRow> rows,
                 std::vector<std::string> names = {});

/// Sets species and labels of a packing from the types of its particles (1 or more) and the names of the
/// types. The labels keep the names only if all differ. Without types, the species follow from the sizes.
void label_by_types(Packing& packing, std::vector<std::int32_t> types, std::vector<std::string> names);

/// Stores the types and their names in the labels of a packing whose species are set, unless they contain no
/// more than the species.
void keep_types(Packing& packing, std::vector<std::int32_t> types, std::vector<std::string> names);

/// Throws InputError that names `file` unless the packing is sound (flaw_of).
void check_packing(const Packing& packing, const std::filesystem::path& file);

}  // namespace furnas
