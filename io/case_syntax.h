#pragma once

#include <string>
#include <string_view>

namespace furnas {

/// "table.key=value" in two, blanks around both taken off; the value is empty without "=".
struct Assignment {
  std::string path;
  std::string value;
};

/// Splits at the first "=".
Assignment split_assignment(std::string_view text);

/// One line on a place where a case file is no TOML: the key and its value as they were written, and what
/// the key may hold if it is known. `complaint` is the parser's own.
std::string explain_syntax(std::string_view text, const std::string& name, std::size_t line,
                           std::string_view complaint);

}  // namespace furnas
