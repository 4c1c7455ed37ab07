#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/text_reader.h"

namespace furnas {

/// The pairs key=value of the second line of a frame of extended XYZ.
///
/// A value ends at a blank, or stands in "..", '..', {..} or [..], which may have blanks in it; within quotes
/// a backslash takes the next character as it is. A word without "=" says nothing.
class XyzAttributes {
 public:
  /// Those of the reader's line; throws InputError where a quote is not closed or a key stands twice.
  explicit XyzAttributes(const TextReader& reader);

  bool has(const std::string& key) const { return values_.contains(key); }
  /// The value of the first of the keys that is there; null without one.
  const std::string* first_of(std::initializer_list<const char*> keys) const;

 private:
  std::map<std::string, std::string> values_;
};

/// The words of a value that is a list: between blanks, commas and brackets.
std::vector<std::string> words_of_list(const std::string& value);

}  // namespace furnas
