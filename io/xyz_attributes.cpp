#include "io/xyz_attributes.h"

#include <algorithm>

namespace furnas {
namespace {

constexpr const char* between_words = " \t";

/// Takes the value that begins at `at` and moves `at` past it.
std::string take_value(const TextReader& reader, const std::string& line, std::size_t& at,
                       const std::string& key) {
  const char open = at < line.size() ? line[at] : ' ';
  if (open == '"' || open == '\'') {
    std::string value;
    for (++at; at < line.size() && line[at] != open; ++at) {
      if (line[at] == '\\' && at + 1 < line.size()) ++at;
      value += line[at];
    }
    if (at >= line.size()) reader.fail("the value of " + key + " has no closing quote");
    ++at;
    return value;
  }
  if (open == '{' || open == '[') {
    const std::size_t begin = at;
    int depth = 0;
    for (; at < line.size(); ++at) {
      if (line[at] == '{' || line[at] == '[') ++depth;
      if (line[at] == '}' || line[at] == ']') --depth;
      if (depth == 0) break;
    }
    if (depth != 0) reader.fail("the value of " + key + " has no closing bracket");
    ++at;
    return line.substr(begin, at - begin);
  }
  const std::size_t begin = at;
  at = std::min(line.find_first_of(between_words, begin), line.size());
  return line.substr(begin, at - begin);
}

}  // namespace

XyzAttributes::XyzAttributes(const TextReader& reader) {
  const std::string& line = reader.line();
  for (std::size_t at = 0; (at = line.find_first_not_of(between_words, at)) != std::string::npos;) {
    const std::size_t end = line.find_first_of("= \t", at);
    // There may be blanks around "=".
    const std::size_t equals = end == std::string::npos ? end : line.find_first_not_of(between_words, end);
    if (equals == std::string::npos || line[equals] != '=') {  // a word without a value
      at = std::min(end, line.size());
      continue;
    }
    const std::string key = line.substr(at, end - at);
    at = std::min(line.find_first_not_of(between_words, equals + 1), line.size());
    if (!values_.emplace(key, take_value(reader, line, at, key)).second)
      reader.fail(key + " occurs twice in the line");
  }
}

const std::string* XyzAttributes::first_of(std::initializer_list<const char*> keys) const {
  for (const char* key : keys)
    if (const auto found = values_.find(key); found != values_.end()) return &found->second;
  return nullptr;
}

std::vector<std::string> words_of_list(const std::string& value) {
  std::vector<std::string> words;
  constexpr const char* between = " \t,[]{}()";
  for (std::size_t at = 0; (at = value.find_first_not_of(between, at)) != std::string::npos;) {
    const std::size_t end = std::min(value.find_first_of(between, at), value.size());
    words.push_back(value.substr(at, end - at));
    at = end;
  }
  return words;
}

}  // namespace furnas
