#pragma once

#include <string>
#include <vector>

namespace furnas {

/// A table of text with named columns, to print for a reader or to write as CSV.
class Table {
 public:
  explicit Table(std::vector<std::string> names) : names_(std::move(names)) {}

  /// Adds a row: a cell for each name.
  void row(std::vector<std::string> cells);

  /// The columns side by side, flush right, with the names above.
  std::string aligned() const;

  /// Comma-separated values with a line of names (io/csv.h).
  std::string csv() const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

/// Median and range of some measurements.
struct Spread {
  double median{}, low{}, high{};
};

/// The spread of at least one measurement.
Spread spread_of(std::vector<double> values);

/// "12.3 (11.9 - 12.6)"
std::string text_of(const Spread& spread);

}  // namespace furnas
