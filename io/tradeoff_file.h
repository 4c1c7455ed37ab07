#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/case.h"

namespace furnas {

/// A case with the settings of an arm.
struct TradeoffArm {
  std::string name;
  Case c;
  bool pressure_alone{};           ///< the arm changes compaction.pressure, to one value, and nothing else
  std::vector<std::string> set{};  ///< what it changes, as assignments of --set
};

/// Arms that are compared on one case.
struct TradeoffCase {
  std::string name;
  std::string reference;  ///< name of the arm, one of `arms`, with which the others are compared
  int samples = 1;  ///< number of samples of each arm; their seeds are mixture.seed, mixture.seed + 1, ...
  double margin{};  ///< of equivalence, in phi
  std::vector<TradeoffArm> arms;
  std::vector<std::string> set{};  ///< what makes it, as assignments of --set
};

/// A file of `furnas bench tradeoff`: a case file whose tables hold the settings of all runs, and in addition
///
///     [tradeoff]                      # samples, margin, reference
///     [cases.NAME]                    # keys of the case in quotes; samples, margin, reference of its own
///     [arms.NAME]                     # keys in quotes, preset among them; cases = ["NAME", ...]: only these
///
/// in the order of the file. Names consist of letters, digits and "._+-", because they become names of
/// folders.
struct TradeoffFile {
  std::vector<TradeoffCase> cases;
};

/// Throws InputError that names file, line, key, value and what is allowed.
TradeoffFile read_tradeoff(const std::filesystem::path& file);

}  // namespace furnas
