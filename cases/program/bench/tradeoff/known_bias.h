#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/case.h"

namespace furnas {

/// docs/results/tradeoff/tradeoff.csv, as it stood when the program was built.
std::string_view stored_tradeoff();

/// What a table of `furnas bench tradeoff` says about the settings of a case, a sentence for each arm of the
/// most similar mixture in the table whose changed keys the case has. Mixtures with and without friction are
/// never compared. With the default settings the sentence is that of the arm `default`.
std::vector<std::string> known_biases(const Case& c, std::string_view table = stored_tradeoff());

}  // namespace furnas
