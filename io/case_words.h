#pragma once

#include <string>
#include <string_view>

#include "io/case.h"
#include "io/case_schema.h"

namespace furnas {

/// The known key most like an unknown one as "table.name"; empty if none is alike.
std::string nearest_key(std::string_view table, std::string_view name);

/// The known table most like an unknown one; empty if none is alike.
std::string nearest_table(std::string_view table);

/// What a key may hold, in words: "1 <= size_ratio <= 100", "\"white\" or \"transparent\"".
std::string allowed_text(const Key& key);

/// The type of a key in words: "real", "integer", "text", ...
std::string type_text(const Key& key);

/// The value of a key in a case as TOML; empty if the field is empty and no word stands for that.
std::string value_text(const Key& key, const Case& c);

}  // namespace furnas
