#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace furnas {

/// Comma-separated values as in RFC 4180, but with Unix line ends.

/// The text of a cell, in quotes if it contains a comma, a quote or a line end.
std::string csv_cell(const std::string& text);

/// A row with its line end; a cell that contains a comma, a quote or a line end is put in quotes.
std::string csv_row(const std::vector<std::string>& cells);

/// The text with ';' for commas and blanks for ends of lines: such a cell needs no quotes, so that a program
/// which knows nothing of them can read the row.
std::string without_commas(std::string text);

/// Reads the next row, with quotes taken off; false at the end of the file. A cell that begins with a quote
/// but does not end with one is taken literally. Throws InputError for quotes that are not closed within a
/// megabyte or before the end of the file; `name` is that of the file.
bool read_csv_row(std::istream& file, std::vector<std::string>& cells, const std::string& name);

}  // namespace furnas
