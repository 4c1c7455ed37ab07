#pragma once

#include <span>
#include <string_view>

namespace furnas {

/// A parser that takes whatever somebody has put into a file.
struct FuzzTarget {
  std::string_view name;  ///< of the folder of its corpus, too
  /// Parses the bytes. What they say is refused with an InputError, which this takes; anything else that
  /// comes out, and every crash, is a mistake of the parser.
  void (*parse)(std::string_view bytes);
};

/// All of them.
std::span<const FuzzTarget> fuzz_targets();

/// The one of this name; throws ContractError.
const FuzzTarget& fuzz_target(std::string_view name);

}  // namespace furnas
