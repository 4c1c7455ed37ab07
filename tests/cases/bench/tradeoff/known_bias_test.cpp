#include "cases/program/bench/tradeoff/known_bias.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace furnas {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* table =
    "case,arm,reference,margin,standing,n,difference,difference_half_width,case_settings,arm_settings,"
    "version\n"
    "equal,careful,careful,0.001,reference,16,,,contact.friction=0.3,preset=reference,1\n"
    "equal,default,careful,0.001,equivalent,16,0.0002,0.0005,contact.friction=0.3,,1\n"
    "equal,long,careful,0.001,different,16,0.013,0.002,contact.friction=0.3,compaction.time_step=0.1,1\n"
    "equal,both,careful,0.001,failed,0,,,contact.friction=0.3,compaction.time_step=0.1 "
    "compaction.inertia=9.0,1\n"
    "equal,few,careful,0.001,undecided,16,0.1,0.1,contact.friction=0.3,mixture.large=30,1\n"
    "equal,later,careful,0.001,unfinished,0,,,contact.friction=0.3,compaction.inertia=9.0,1\n"
    "mixed,default,careful,0.001,undecided,4,0.002,0.004,contact.friction=0.3 mixture.size_ratio=5.0 "
    "mixture.small_fraction=0.2,,1\n";

TEST(KnownBias, IsThatOfTheArmWhoseKeysTheCaseHas) {
  Case c;
  EXPECT_THAT(known_biases(c, table), ElementsAre(HasSubstr("default settings: phi_J differs by +0.0002")));
  c.compaction.time_step = 0.1;
  EXPECT_THAT(known_biases(c, table),
              ElementsAre(HasSubstr("compaction.time_step=0.1: phi_J differs by +0.0130 +- 0.0020 (95 %)")));
  c.compaction.inertia = 9;
  EXPECT_THAT(known_biases(c, table), ElementsAre(HasSubstr("no sample came to rest")));
}

TEST(KnownBias, IsThatOfTheMostSimilarMixture) {
  Case c;
  c.mixture.size_ratio = 4;
  c.mixture.small_fraction = 0.5;
  EXPECT_THAT(known_biases(c, table), ElementsAre(HasSubstr("mixture.size_ratio=5.0")));
  c.contact.friction = 0;
  EXPECT_THAT(known_biases(c, table), IsEmpty()) << "a case with friction says nothing about one without";
}

TEST(KnownBias, OfSpheresFromAFileIsNotKnown) {
  Case from_file, listed;
  from_file.start.file = "start.vtp";
  listed.mixture.diameters = "list.txt";
  EXPECT_THAT(known_biases(from_file, table), IsEmpty());
  EXPECT_THAT(known_biases(listed, table), IsEmpty());
}

TEST(KnownBias, OfOneSampleHasNoInterval) {
  std::string one = table;
  const std::string interval = "0.0002,0.0005,";
  one.replace(one.find(interval), interval.size(), "0.0002,,");
  EXPECT_THAT(known_biases({}, one), ElementsAre(HasSubstr("differs by +0.0002 (without interval) from")));
}

TEST(KnownBias, IsReadFromTheStoredTable) {
  Case c;
  EXPECT_THAT(known_biases(c), ElementsAre(HasSubstr("default settings: phi_J differs by")));
}

}  // namespace
}  // namespace furnas
