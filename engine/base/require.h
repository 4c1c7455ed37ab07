#pragma once

#include <source_location>
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

/// Throws ContractError with the caller's place unless `holds`.
inline void require(bool holds, const char* what,
                    std::source_location place = std::source_location::current()) {
  if (!holds)
    throw ContractError(std::string(place.file_name()) + ":" + std::to_string(place.line()) + ": " + what);
}

}  // namespace furnas
