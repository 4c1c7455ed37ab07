#pragma once

#include <string>
#include <vector>

#include "cases/program/figures/figures.h"

namespace furnas {

/// What a study says of a statement of the paper.
enum class Agreement { reproduced, not_reproduced, not_reachable };

/// A statement of the paper beside what a study has.
struct Statement {
  std::string what;
  std::string paper;  ///< its value
  std::string ours;   ///< with intervals; "-" without data
  std::string n;      ///< samples behind it
  Agreement agreement = Agreement::not_reachable;
  std::string rule;  ///< when it counts as reproduced
};

/// The statements of the paper (arXiv 2105.00977), in its order.
std::vector<Statement> statements_of(const Study& study);

/// report.md: the statements, the numbers behind them, and the figures, which lie beside it.
std::string report(const Study& study, const std::vector<Figure>& figures);

}  // namespace furnas
