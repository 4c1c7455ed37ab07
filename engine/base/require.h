#pragma once

#include <stdexcept>
#include <string>

namespace furnas {

/// A broken contract between two parts of the program: a bug, not a user's mistake.
struct ContractError : std::logic_error {
  using std::logic_error::logic_error;
};

/// What the user gave cannot be used; the message names what, its value and what is allowed.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The physics has left what can be computed, such as a cell that collapsed: an outcome, not a mistake.
struct NumericalFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws ContractError with the caller's place unless `holds`. (std::source_location is unknown to
/// clang-tidy 14.)
inline void require(bool holds, const char* what, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE()) {
  if (!holds) throw ContractError(std::string(file) + ":" + std::to_string(line) + ": " + what);
}

}  // namespace furnas
