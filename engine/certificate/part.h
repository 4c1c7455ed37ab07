#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace furnas {

/// One number of a certificate, with its limit if it has one.
struct Finding {
  enum class Bound { none, at_most, at_least };

  std::string name;  ///< with its unit
  double value{};
  Bound bound = Bound::none;
  double limit{};

  /// Whether the value is within its limit; NaN never is.
  bool holds() const {
    return bound == Bound::none || (bound == Bound::at_most ? value <= limit : value >= limit);
  }
};

inline Finding told(std::string name, double value) { return {std::move(name), value}; }
inline Finding at_most(std::string name, double value, double limit) {
  return {std::move(name), value, Finding::Bound::at_most, limit};
}
inline Finding at_least(std::string name, double value, double limit) {
  return {std::move(name), value, Finding::Bound::at_least, limit};
}

/// What a part that passes proves about the packing.
enum class Proves {
  necessary,   ///< every jammed packing passes; a packing that passes need not be jammed
  sufficient,  ///< if the forces balance, the packing is stable against all small motions, to first order
  neither,     ///< a jammed packing may fail, and a packing that passes need not be jammed
};

/// One part of a certificate: a question, and the numbers that answer it.
struct Part {
  std::string name;
  std::string asks;  ///< the question, in a sentence
  Proves proves = Proves::necessary;
  std::vector<Finding> findings;
  std::string note;  ///< a remark for the reader; may be empty

  bool passed() const {
    return std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.holds(); });
  }
};

}  // namespace furnas
