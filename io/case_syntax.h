#pragma once

#include <string>
#include <string_view>

namespace furnas {

/// The two sides of "table.key=value" without the blanks around them; the value is empty without "=".
struct Assignment {
  std::string path;
  std::string value;
};

/// Splits at the first "=".
Assignment split_assignment(std::string_view text);

/// A one-line message about the place where a case file is not valid TOML: the key and its value as written
/// and, for a known key, the allowed values. `complaint` is the parser's message.
std::string explain_syntax(std::string_view text, const std::string& name, std::size_t line,
                           std::string_view complaint);

}  // namespace furnas
