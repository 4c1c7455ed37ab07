#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace furnas {

/// One number of a certificate, and the limit it must keep if it has one.
struct Finding {
  enum class Bound { none, at_most, at_least };

  std::string name;  ///< with its unit
  double value{};
  Bound bound = Bound::none;
  double limit{};

  /// A value that is no number holds no limit.
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
  necessary,   ///< a jammed packing must pass; one that passes may still not be jammed
  sufficient,  ///< with the balance of forces, it is stable against all small motions, to first order
};

/// One question of a certificate and its answer.
struct Part {
  std::string name;
  std::string asks;  ///< the question, in a sentence
  Proves proves = Proves::necessary;
  std::vector<Finding> findings;
  std::string note;  ///< what a reader should know besides; may be empty

  bool passed() const {
    return std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.holds(); });
  }
};

}  // namespace furnas
