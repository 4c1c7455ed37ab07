#include "io/case_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <vector>

#include "engine/base/require.h"
#include "io/case_words.h"

namespace furnas {
namespace {

/// A key, the value given for it, and the place in the file.
struct Given {
  const Key& key;
  const toml::node& node;
  const std::string& place;

  [[noreturn]] void refuse(std::string_view why) const {
    throw InputError(fmt::format("{}: {} = {} {}; allowed: {}", place, key.path(), node_text(node), why,
                                 allowed_text(key)));
  }
};

double checked(const Given& given, double value) {
  const auto* range = std::get_if<Range>(&given.key.allowed);
  if (!std::isfinite(value) || (range != nullptr && !range->contains(value))) given.refuse("is not allowed");
  return value;
}

/// A real number, which may be written as an integer.
std::optional<double> real(const toml::node& node) {
  if (!node.is_number()) return {};
  return node.value<double>();
}

void set(const Given& given, bool& field) {
  if (!given.node.is_boolean()) given.refuse("is neither true nor false");
  field = *given.node.value<bool>();
}

void set(const Given& given, double& field) {
  const auto value = real(given.node);
  if (!value) given.refuse("is not a number");
  field = checked(given, *value);
}

void set(const Given& given, std::int64_t& field) {
  constexpr double exact = 0x1p53;  // up to here every integer is a double
  const auto value = real(given.node);
  if (!value || (!given.node.is_integer() && (*value != std::nearbyint(*value) || std::abs(*value) > exact)))
    given.refuse("is not an integer");
  checked(given, *value);
  field = given.node.is_integer() ? *given.node.value<std::int64_t>() : static_cast<std::int64_t>(*value);
}

void set(const Given& given, int& field) {
  std::int64_t value = 0;
  set(given, value);
  field = static_cast<int>(value);
}

void set(const Given& given, std::string& field) {
  if (!given.node.is_string()) given.refuse("is not text in quotes");
  const auto value = *given.node.value<std::string>();
  const auto* choices = std::get_if<Choices>(&given.key.allowed);
  if (choices != nullptr && std::find(choices->begin(), choices->end(), value) == choices->end())
    given.refuse("is not allowed");
  field = value;
}

void set(const Given& given, std::vector<double>& field) {
  std::vector<double> values;
  if (const toml::array* list = given.node.as_array()) {
    for (const toml::node& element : *list) {
      const auto value = real(element);
      if (!value) given.refuse("is not a list of numbers");
      values.push_back(checked(given, *value));
    }
    if (values.empty()) given.refuse("is an empty list");
  } else {
    set(given, values.emplace_back());
  }
  field = values;
}

template <class Value>
void set(const Given& given, std::optional<Value>& field) {
  const auto word = given.node.value<std::string_view>();
  if (word && !given.key.when_empty.empty() && *word == given.key.when_empty) {
    field.reset();
    return;
  }
  Value value{};
  set(given, value);
  field = value;
}

/// The value as TOML; real numbers in the fewest digits, where toml++ writes seventeen.
std::string whole_text(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const toml::array* list = node.as_array()) {
    std::vector<std::string> elements;
    for (const toml::node& element : *list) elements.push_back(whole_text(element));
    return fmt::format("[{}]", fmt::join(elements, ", "));
  }
  std::ostringstream stream;
  stream << toml::toml_formatter{node, toml::format_flags::none};
  return stream.str();
}

}  // namespace

std::string node_text(const toml::node& node) {
  constexpr std::size_t longest = 60;
  std::string text = whole_text(node);
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

void assign(const Key& key, const toml::node& node, Case& c, const std::string& place) {
  const Given given{key, node, place};
  std::visit([&](auto* field) { set(given, *field); }, key.field(c));
}

}  // namespace furnas
