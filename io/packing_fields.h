#pragma once

#include <span>
#include <string_view>

#include "io/output_field.h"

namespace furnas {

/// Describes the content of the files of a packing, for `furnas schema --outputs`. The writers are in the
/// files of the formats; tests/io/packing_fields_test.cpp checks that they write what is described here.

/// An array of a VTP file, and its place in the file.
struct VtpField {
  enum class Place { field, point, cell } place;  ///< FieldData, PointData, CellData
  OutputField about;
};

/// The arrays of packing.vtp.
std::span<const VtpField> packing_vtp_fields();

/// The arrays of contacts.vtp.
std::span<const VtpField> contacts_vtp_fields();

/// The properties of the second line of an extended XYZ file.
std::span<const OutputField> extended_xyz_fields();

/// The columns of packing.csv.
std::span<const OutputField> packing_csv_fields();

/// The columns of a table of contacts.
std::span<const OutputField> contacts_csv_fields();

}  // namespace furnas
