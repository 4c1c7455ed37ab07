#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

#include "cases/program/sweep/sample_table.h"
#include "io/output_field.h"

namespace furnas {

/// A column of sweep.csv after those of the keys. The table of all is the only place that knows their names;
/// reading, writing, plotting and documenting all go through it.
struct SampleColumn {
  using Value = std::variant<std::int64_t*, double*, std::string*>;
  OutputField about;
  std::string_view title;  ///< on the axis of a chart; empty: it is no number
  Value (*value)(SampleRow&);
};

/// All columns, in the order of the file.
std::span<const SampleColumn> sample_columns();

/// Every version has written at least this number of columns; tables of older versions may lack the others.
inline constexpr std::size_t oldest_sample_columns = 19;

/// The cell of a row in a column; empty where the value is not known.
std::string cell_of(const SampleColumn& column, const SampleRow& row);

/// Its number; nothing if it is a word or not known.
std::optional<double> number_of(const SampleColumn& column, const SampleRow& row);

}  // namespace furnas
