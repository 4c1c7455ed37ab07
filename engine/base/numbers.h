#pragma once

#include <algorithm>
#include <charconv>
#include <concepts>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace furnas {

/// Converts the whole word to a number, exact to the last bit; returns nothing if the word is no number or
/// the number is out of range. Unlike a stream it accepts infinity and NaN as numbers.
template <class Number>
std::optional<Number> number_in(std::string_view word) {
  Number value{};
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || rest != word.data() + word.size()) return {};
  return value;
}

/// Reads the numbers of a text, separated by blanks or ends of lines. The text must outlive the object.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : rest_(text) {}

  /// Whether another word follows.
  bool more() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    return !rest_.empty();
  }

  /// Reads one word for each value, a bool as 0 or 1. Returns false if a word is missing or is no number of
  /// the value's type.
  template <class... Values>
  bool take(Values&... values) {
    return (take_one(values) && ...);
  }

  /// Like take(); also returns false if anything is left over, even a blank.
  template <class... Values>
  bool take_all(Values&... values) {
    return take(values...) && rest_.empty();
  }

 private:
  static constexpr std::string_view blanks = " \t\n\v\f\r";

  template <class Value>
  bool take_one(Value& value) {
    if (!more()) return false;
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
    rest_.remove_prefix(word.size());
    if constexpr (std::is_same_v<Value, bool>) {
      value = word == "1";
      return value || word == "0";
    } else {
      const std::optional<Value> number = number_in<Value>(word);
      value = number.value_or(Value{});
      return number.has_value();
    }
  }

  std::string_view rest_;
};

/// A number as text from which the same bits are read back: 17 digits without trailing zeros.
inline std::string exact_text(double value) {
  char digits[32];
  constexpr int count = std::numeric_limits<double>::max_digits10;
  return {digits, std::to_chars(digits, std::end(digits), value, std::chars_format::general, count).ptr};
}
template <std::integral Whole>
std::string exact_text(Whole value) {
  return std::to_string(value);
}

/// Several numbers with blanks between them, as Numbers reads them: "2 0.5 1".
template <class First, class... Others>
requires(sizeof...(Others) > 0) std::string exact_text(First first, Others... others) {
  return exact_text(first) + ((' ' + exact_text(others)) + ...);
}

}  // namespace furnas
