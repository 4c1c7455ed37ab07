#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/text_reader.h"

namespace furnas {

/// The pairs key=value of the second line of a frame of extended XYZ.
///
/// A value ends at a blank, or is enclosed in "..", '..', {..} or [..] and may then contain blanks. Within
/// quotes a backslash makes the next character literal. A word without "=" is ignored.
class XyzAttributes {
 public:
  /// Reads the pairs in the reader's line; throws InputError where a quote is not closed or a key occurs
  /// twice.
  explicit XyzAttributes(const TextReader& reader);

  /// The value of the first of these keys that exists; null if none exists.
  const std::string* first_of(std::initializer_list<const char*> keys) const;

 private:
  std::map<std::string, std::string> values_;
};

/// The words of a value that is a list: between blanks, commas and brackets.
std::vector<std::string> words_of_list(const std::string& value);

}  // namespace furnas
