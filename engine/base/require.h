#pragma once

#include <stdexcept>
#include <string>

namespace furnas {

/// A violated precondition between two parts of the program: a bug, not a user's mistake.
struct ContractError : std::logic_error {
  using std::logic_error::logic_error;
};

/// An input of the user cannot be used; the message names the input, its value and the allowed values.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The state can no longer be computed, for example because the cell collapsed: an outcome of the run, not a
/// mistake.
struct NumericalFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws ContractError with file and line of the caller unless `holds`. std::source_location is not used,
/// because clang-tidy 14 does not support it.
inline void require(bool holds, const char* what, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE()) {
  if (!holds) throw ContractError(std::string(file) + ":" + std::to_string(line) + ": " + what);
}

}  // namespace furnas
