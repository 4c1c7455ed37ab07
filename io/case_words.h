#pragma once

#include <string>
#include <string_view>

#include "io/case.h"
#include "io/case_schema.h"

namespace furnas {

/// The known key, as "table.name", that is most similar to an unknown one; empty if none is similar.
std::string nearest_key(std::string_view table, std::string_view name);

/// The known table that is most similar to an unknown one; empty if none is similar.
std::string nearest_table(std::string_view table);

/// The allowed values of a key, in words: "1 <= size_ratio <= 100", "\"white\" or \"transparent\"".
std::string allowed_text(const Key& key);

/// The type of a key in words: "real", "integer", "text", ...
std::string type_text(const Key& key);

/// The value of a key in a case as TOML; empty if the field is empty and has no word for that.
std::string value_text(const Key& key, const Case& c);

}  // namespace furnas
