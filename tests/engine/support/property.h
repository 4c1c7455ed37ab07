#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <cstdint>
#include <sstream>

namespace furnas::test {

/// A seed for Dice. Small ones are no simpler than large ones, so it never shrinks.
inline std::uint64_t any_seed() {
  return *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
}

/// Whether a RapidCheck property holds in `cases` random cases. Silent unless it fails; the cases are the
/// same in every run, so that a commit that passes here passes everywhere.
template <class Property>
::testing::AssertionResult holds(int cases, Property&& property) {
  rc::detail::TestParams params;
  params.seed = 20210500977;
  params.maxSuccess = cases;
  rc::detail::TestListenerAdapter silent;
  const auto result =
      rc::detail::checkTestable(std::forward<Property>(property), rc::detail::TestMetadata{}, params, silent,
                                std::unordered_map<std::string, rc::detail::Reproduce>{});
  if (result.template is<rc::detail::SuccessResult>()) return ::testing::AssertionSuccess();
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  return ::testing::AssertionFailure() << text.str();
}

}  // namespace furnas::test
