#pragma once

#include <toml++/toml.h>

#include <string>

#include "io/case.h"
#include "io/case_schema.h"

namespace furnas {

/// A TOML value on one line, cut if it is long.
std::string node_text(const toml::node& node);

/// Sets the field of `key` to a TOML value; throws InputError, which begins with `place`, if its type or
/// its range is wrong.
void assign(const Key& key, const toml::node& node, Case& c, const std::string& place);

}  // namespace furnas
