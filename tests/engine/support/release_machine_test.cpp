#include "tests/engine/support/release_machine.h"

#include <gtest/gtest.h>

namespace furnas::test {
namespace {

TEST(ReleaseMachine, ReadsVersions) {
  EXPECT_EQ(leading_numbers("12.2.0", 1), "12");
  EXPECT_EQ(leading_numbers("14.0.6 (Debian)", 1), "14");
  EXPECT_EQ(leading_numbers("2.36", 2), "2.36");
  EXPECT_EQ(leading_numbers("2.36.9000", 2), "2.36");
  EXPECT_EQ(leading_numbers("2.4", 2), "2.4");
  EXPECT_EQ(leading_numbers("13", 2), "13");
}

TEST(ReleaseMachine, NamesEachDifference) {
  EXPECT_EQ(difference(release_machine, release_machine), "");
  EXPECT_EQ(difference({"g++ 13", "glibc 2.36", "x86-64"}, release_machine),
            "The hashes of the release were made on another machine; here is g++ 13 instead of g++ 12.");
  EXPECT_EQ(
      difference({"g++ 12", "glibc 2.41", "ARM64"}, release_machine),
      "The hashes of the release were made on another machine; here is glibc 2.41 instead of glibc 2.36, "
      "ARM64 instead of x86-64.");
}

TEST(ReleaseMachine, KnowsThisOne) {
  const Machine here = this_machine();
  EXPECT_NE(here.compiler.find_first_of("123456789"), std::string::npos) << here.compiler;
  EXPECT_FALSE(here.c_library.empty());
  EXPECT_FALSE(here.architecture.empty());
}

}  // namespace
}  // namespace furnas::test
