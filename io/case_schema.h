#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/case.h"

namespace furnas {

/// Numbers a key may take, and for a list each of its elements.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above_least = false;  ///< `least` itself is not allowed
  bool below_most = false;   ///< `most` itself is not allowed

  /// False for NaN and for the infinities too.
  bool contains(double value) const;
};

/// The words a key may take.
using Choices = std::vector<std::string_view>;

/// The field of a Case that a key sets; its type is the type of the key.
using Field = std::variant<bool*, int*, std::int64_t*, double*, std::string*, std::vector<double>*,
                           std::optional<int>*, std::optional<double>*>;

/// One key of the case file. The table of all keys is the only place that knows a key's name, unit,
/// range and documentation; reading, writing, overriding and documenting all go through it.
struct Key {
  std::string_view table;  ///< empty: above all tables
  std::string_view name;
  std::string_view unit;                                 ///< empty: a pure number or a word
  std::variant<std::monostate, Range, Choices> allowed;  ///< nothing: any value of its type
  std::string_view when_empty;  ///< the word for an empty optional field; empty: the key is left out
  std::string_view rival;       ///< the key of the same table that sets the same quantity in another unit
  std::string_view doc;         ///< one line
  Field (*field)(Case&);

  /// "table.name", or the name alone, as in --set.
  std::string path() const;
};

/// All keys, those of a table together, in the order in which a case is written.
std::span<const Key> case_keys();

/// The tables of a case file in the order of `case_keys`.
std::vector<std::string_view> case_tables();

/// Whether every value of the key gives the same packing, step by step; a stopped run may then continue with
/// another value.
bool changes_no_bit(const Key& key);

/// The key with this table and name, or with this path, like "contact.friction" or "preset"; or nullptr.
const Key* find_key(std::string_view table, std::string_view name);
const Key* find_key(std::string_view path);

/// Sets a key to its default.
void reset(const Key& key, Case& c);

}  // namespace furnas
