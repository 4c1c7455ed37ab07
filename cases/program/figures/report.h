#pragma once

#include <string>
#include <vector>

#include "cases/program/figures/figures.h"

namespace furnas {

/// Whether a study reproduces a statement of the paper.
enum class Agreement {
  reproduced,
  not_excluded,  ///< a number differs by more than the tolerance, but the interval leaves room for agreement
  not_reproduced,
  not_reachable  ///< the data cannot decide
};

/// A statement of the paper beside the result of a study.
struct Statement {
  std::string what;
  std::string paper;  ///< value in the paper
  std::string ours;   ///< with intervals; "-" without data
  std::string n;      ///< number of samples used
  Agreement agreement = Agreement::not_reachable;
  std::string rule;  ///< condition for "reproduced"
};

/// The statements of the paper (arXiv 2105.00977), in its order.
std::vector<Statement> statements_of(const Study& study);

/// report.md: the statements, their numbers, and the figures, whose files are in the same folder.
std::string report(const Study& study, const std::vector<Figure>& figures);

}  // namespace furnas
