#pragma once

#include <optional>
#include <string>

#include "io/case.h"

namespace furnas {

/// Why keys with values that are allowed one by one exclude each other.
struct Conflict {
  std::string key;      ///< "table.name" of the key to change first
  std::string message;  ///< names the keys, their values and what is allowed
};

/// The first conflict between keys, if any.
std::optional<Conflict> find_conflict(const Case& c);

/// Throws InputError if a value is out of its range or keys are in conflict.
void validate(const Case& c);

}  // namespace furnas
