#include "io/case_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/base/require.h"
#include "engine/monitor/stability.h"
#include "io/case_check.h"
#include "io/case_preset.h"
#include "io/case_protocol.h"
#include "io/case_schema.h"
#include "io/case_words.h"

namespace furnas {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

/// The complaint about a case, or nothing if it is accepted.
std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_case(text, "case.toml", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

struct BadInput {
  const char* what;
  std::string text;
  std::vector<std::string> expected;  ///< file and line, key, value, allowed
};

const std::vector<BadInput> bad_inputs = {
    {"NaN",
     "[contact]\nfriction = nan\n",
     {"case.toml:2:", "contact.friction = nan", "0 <= friction <= 1e+30"}},
    {"infinity", "[contact]\nfriction = inf\n", {"case.toml:2:", "contact.friction = inf", "<= 1e+30"}},
    {"1e400",
     "[contact]\nfriction = 1e400 # much\n",
     {"case.toml:2:", "contact.friction = 1e400 ", "<= 1e+30"}},
    {"beyond 64 bits",
     "[mixture]\nseed = 99999999999999999999\n",
     {"case.toml:2:", "mixture.seed = 9999", "seed <="}},
    {"negative friction",
     "[contact]\nfriction = -0.3\n",
     {"case.toml:2:", "contact.friction = -0.3", "0 <= fric"}},
    {"alpha below 1",
     "[mixture]\nsize_ratio = 0.5\n",
     {"case.toml:2:", "size_ratio = 0.5", "1 <= size_ratio <= 100"}},
    {"f_s of 1",
     "[mixture]\nsmall_fraction = 1\n",
     {"case.toml:2:", "small_fraction = 1", "0 <= small_fraction < 1"}},
    {"negative f_s",
     "[mixture]\nsmall_fraction = -0.1\n",
     {"small_fraction = -0.1", "0 <= small_fraction < 1"}},
    {"no large sphere", "[mixture]\nlarge = 0\n", {"case.toml:2:", "mixture.large = 0", "1 <= large"}},
    {"fraction of a sphere",
     "[mixture]\nlarge = 10.5\n",
     {"mixture.large = 10.5", "not an integer", "1 <= large"}},
    {"no number at all", "[mixture]\nlarge = nan\n", {"mixture.large", "1 <= large"}},
    {"pressure of the stiffness",
     "[compaction]\npressure = 1\n",
     {"compaction.pressure = 1", "0 < pressure <= 0.1"}},
    {"negative pressure",
     "[compaction]\npressure = -1e-4\n",
     {"compaction.pressure = -", "0 < pressure <= 0.1"}},
    {"zero pressure", "[compaction]\npressure = 0\n", {"compaction.pressure = 0", "0 < pressure <= 0.1"}},
    {"bad step of a staircase",
     "[compaction]\npressure = [1e-3, -1e-4]\n",
     {"pressure = [", "0 < pressure <= 0.1"}},
    {"empty staircase", "[compaction]\npressure = []\n", {"pressure = []", "empty", "a list of them"}},
    {"word in a staircase",
     "[compaction]\npressure = [1e-3, \"x\"]\n",
     {"not a list of numbers", "0 < pressure"}},
    {"text for a number",
     "[contact]\nfriction = \"abc\"\n",
     {"contact.friction = \"abc\"", "not a number", "<= 1e+30"}},
    {"bare word", "[contact]\nfriction = abc\n", {"case.toml:2:", "contact.friction = abc", "0 <= friction"}},
    {"no value", "[contact]\nfriction =\n", {"case.toml:2:", "contact.friction =", "0 <= friction"}},
    {"number for text", "[contact]\nlaw = 3\n", {"contact.law = 3", "not text", "\"hooke_history\""}},
    {"number for a truth", "[contact]\nattraction = 1\n", {"contact.attraction = 1", "true or false"}},
    {"unknown choice",
     "[compaction]\ncell = \"cube\"\n",
     {"compaction.cell = \"cube\"", "\"cubic\" or \"fixed\""}},
    {"unknown law", "[contact]\nlaw = \"hertz\"\n", {"contact.law = \"hertz\"", "\"hooke_synchronized\""}},
    {"unknown key",
     "[contact]\nfrction = 0.3\n",
     {"case.toml:2:", "contact.frction = 0.3", "contact.friction"}},
    {"key of another table",
     "[compaction]\nfriction = 0.3\n",
     {"compaction.friction = 0.3", "contact.friction"}},
    {"key like no other", "[stop]\nxyzzy = 1\n", {"stop.xyzzy = 1", "known are criterion, stress_error"}},
    {"key without a table", "friction = 0.3\n", {"case.toml:1:", "friction = 0.3", "contact.friction"}},
    {"unknown table", "[contcat]\nfriction = 0.3\n", {"case.toml:1:", "[contcat]", "[contact]"}},
    {"table like no other", "[quux]\n", {"case.toml:1:", "[quux]", "[mixture], [start], [contact]"}},
    {"value for a table", "contact = 3\n", {"case.toml:1:", "contact = 3", "[contact]"}},
    {"list of tables", "[[contact]]\nfriction = 0.3\n", {"case.toml:1:", "contact", "[contact] once"}},
    {"key twice",
     "[contact]\nfriction = 0.3\nfriction = 0.2\n",
     {"case.toml:3:", "contact.friction = 0.2", "once"}},
    {"table twice", "[contact]\n[stop]\n[contact]\n", {"case.toml:3:", "[contact]", "once"}},
    {"torn header", "[contact\nfriction = 0.3\n", {"case.toml:1:", "[contact"}},
    {"threads", "[compute]\nthreads = 0\n", {"compute.threads = 0", "\"auto\" or 1 <= threads <= 1024"}},
    {"threads in words",
     "[compute]\nthreads = \"many\"\n",
     {"compute.threads = \"many\"", "\"auto\" or 1 <="}},
    {"unknown precision",
     "[compute]\nprecision = \"single\"\n",
     {"compute.precision = \"single\"", "\"mixed\"", "\"double\""}},
    {"long time step",
     "[compaction]\ntime_step = 0.5\n",
     {"compaction.time_step = 0.5", "0 < time_step <= 0.2"}},
    {"unstable time step",
     "[compaction]\ntime_step_absolute = 2\n",
     {"case.toml:2:", "compaction.time_step_absolute = 2", "allowed: below 0."}},
    {"stiff tangential spring",
     "[contact]\ntangential_stiffness = 10\ntangential_damping = 8\n[compaction]\ntime_step = 0.2\n",
     {"case.toml:5:", "compaction.time_step = 0.2", "allowed: below 0."}},
    {"too many spheres",
     "[mixture]\nsize_ratio = 100\nsmall_fraction = 0.9\nlarge = 1000\n",
     {"case.toml:4:", "mixture.large = 1000", "9e+09", "at most 2147483647"}},
    {"not one small sphere",
     "[mixture]\nsmall_fraction = 0.1\nlarge = 1\n",
     {"case.toml:2:", "small_fraction = 0.1", "less than one small sphere"}},
    {"too small a cell",
     "[mixture]\nlarge = 2\n",
     {"case.toml:2:", "mixture.large = 2", "too small to jam; allowed: at least 10, and from 23 on"}},
    {"listed and mixed",
     "[mixture]\nlarge = 50\ndiameters = \"a.txt\"\n",
     {"case.toml:3:", "mixture.diameters = \"a.txt\"", "leave one of them out"}},
    {"read and drawn",
     "[mixture]\nlarge = 1000\n[start]\nfile = \"a.data\"\n",
     {"case.toml:4:", "a.data", "[mixture]"}},
    {"two inertias",
     "[compaction]\ninertia = 1\ninertia_absolute = 10\n",
     {"case.toml:", "compaction.inertia", "compaction.inertia_absolute", "one of them"}},
    {"two time steps",
     "[compaction]\ntime_step = 0.02\ntime_step_absolute = 0.03\n",
     {"compaction.time_step", "compaction.time_step_absolute", "one of them"}},
};

TEST(CaseFile, RefusesBadInputInOneLineWithKeyValueAndRange) {
  for (const BadInput& bad : bad_inputs) {
    const std::string message = complaint(bad.text);
    EXPECT_FALSE(message.empty()) << bad.what << " was accepted";
    EXPECT_EQ(message.find('\n'), std::string::npos) << bad.what;
    for (const std::string& fragment : bad.expected) EXPECT_THAT(message, HasSubstr(fragment)) << bad.what;
  }
}

TEST(CaseFile, AcceptsByteOrderMarkCarriageReturnsAndIntegersForReals) {
  const Case c =
      parse_case("\xEF\xBB\xBF[contact]\r\nfriction = 1\r\n[mixture]\r\nlarge = 2_000\r\n", "case.toml");
  EXPECT_EQ(c.contact.friction, 1.0);
  EXPECT_EQ(c.mixture.large, 2000);
}

TEST(CaseFile, EmptyFileIsTheDefaultCase) { EXPECT_EQ(parse_case("", "case.toml"), Case{}); }

TEST(CaseFile, PressureIsANumberOrAStaircase) {
  EXPECT_EQ(parse_case("compaction.pressure = 1e-3", "").compaction.pressure, std::vector<double>{1e-3});
  EXPECT_EQ(parse_case("compaction.pressure = [1e-3, 1e-4]", "").compaction.pressure,
            (std::vector<double>{1e-3, 1e-4}));
}

TEST(CaseFile, DefaultsAreAllowedAndDocumented) {
  EXPECT_NO_THROW(validate(Case{}));
  for (const Key& key : case_keys()) {
    EXPECT_FALSE(key.doc.empty()) << key.path();
    EXPECT_EQ(key.doc.find('\n'), std::string_view::npos) << key.path();
    EXPECT_EQ(find_key(key.table, key.name), &key) << key.path() << " stands twice in the table";
    if (!key.rival.empty()) {
      ASSERT_NE(find_key(key.table, key.rival), nullptr) << key.path();
      EXPECT_EQ(find_key(key.table, key.rival)->rival, key.name);
    }
  }
}

TEST(CaseFile, ResolvedCaseReadsBackTheSame) {
  EXPECT_EQ(parse_case(resolved_toml(Case{}), "resolved.toml"), Case{});

  Case c;
  c.mixture = {
      .size_ratio = 20.0 / 3, .small_fraction = 0.1 + 0.2, .large = 77, .start_fraction = 0.1, .seed = 42};
  c.contact = {"hooke_history", 1e30, 0.7, 1e-300, 0, false, false, "total"};
  c.compaction = {.pressure = {1e-3, 1.0 / 3e4},
                  .cell = "cubic",
                  .inertia_absolute = 123.456,
                  .drag = 0.04,
                  .time_step = {},
                  .time_step_absolute = 0.03,
                  .mass_exponent = 2.5};
  c.stop = {"paper", 1e-2, 1e-3, 1e-12, 1e-7, 5, 10, 1e3, 2, false, 0};
  c.compute = {"double", 3, 0.25};
  c.output = {10, 20, 0.02, 0.5, "none", 512, "transparent"};
  EXPECT_EQ(parse_case(resolved_toml(c), "resolved.toml"), c);

  Case listed;
  listed.mixture.diameters = "sizes.txt";
  EXPECT_EQ(parse_case(resolved_toml(listed), "resolved.toml"), listed);
  EXPECT_EQ(resolved_toml(listed).find("size_ratio = "), std::string::npos);

  Case read;
  read.start.file = "a \"quoted\" \\ path.data";
  EXPECT_EQ(parse_case(resolved_toml(read), "resolved.toml"), read);
}

TEST(CaseFile, ResolvedCaseNamesEveryKeyWithItsUnit) {
  const std::string text = resolved_toml(Case{});
  for (const Key& key : case_keys()) {
    if (key.table == "start") continue;
    EXPECT_THAT(text, HasSubstr(std::string(key.name)));
  }
  EXPECT_THAT(text, ContainsRegex("friction = 0.3 +# Coulomb's"));
  EXPECT_THAT(text, HasSubstr("threads = \"auto\""));
}

TEST(CaseFile, OverrideSetsOneKey) {
  const Case c =
      parse_case("[contact]\nfriction = 0.3\n[compaction]\ntime_step = 0.01\n", "case.toml",
                 std::vector<std::string>{"contact.friction=0", "contact.law = hooke_history",
                                          "compaction.pressure=[1e-3, 1e-4]", "compute.threads=2",
                                          "compute.skin=auto", "compaction.time_step_absolute=0.03"});
  EXPECT_EQ(c.contact.friction, 0);
  EXPECT_EQ(c.contact.law, "hooke_history");
  EXPECT_EQ(c.compaction.pressure.size(), 2U);
  EXPECT_EQ(c.compute.threads, 2);
  EXPECT_FALSE(c.compute.skin.has_value());
  EXPECT_EQ(time_step_of(protocol_of(c)), 0.03);
}

TEST(CaseFile, APresetStandsInForTheDefaults) {
  const Case paper = parse_case("preset = \"paper\"\n", "case.toml");
  EXPECT_EQ(paper.contact.law, "hooke_history");
  EXPECT_EQ(paper.contact.velocity, "peculiar");
  EXPECT_EQ(paper.compaction.time_step, 0.02);
  EXPECT_EQ(paper.stop.criterion, "paper");
  EXPECT_EQ(paper.compaction.cell_damping, Case{}.compaction.cell_damping) << "not of the preset";
  for (const Preset& preset : presets()) {
    const Case c = parse_case("", "case.toml", std::vector{"preset=" + std::string(preset.name)});
    EXPECT_NE(c, Case{}) << preset.name;
    EXPECT_EQ(parse_case(resolved_toml(c), "resolved.toml"), c) << preset.name;
    EXPECT_NO_THROW(validate(c));
  }
}

TEST(CaseFile, AKeyCountsBeforeThePreset) {
  const std::string text = "preset = \"paper\"\n[contact]\nvelocity = \"total\"\n";
  EXPECT_EQ(parse_case(text, "case.toml").contact.velocity, "total");
  EXPECT_EQ(parse_case(text, "case.toml").contact.law, "hooke_history");
  const auto with = [&](std::vector<std::string> set) { return parse_case(text, "case.toml", set); };
  EXPECT_EQ(with({"stop.criterion=rest", "preset=paper"}).stop.criterion, "rest") << "in whatever order";
  EXPECT_EQ(with({"preset=none"}).contact.law, Case{}.contact.law) << "the last preset alone counts";
  EXPECT_EQ(with({"preset=none"}).contact.velocity, "total");
}

TEST(CaseFile, AnUnknownPresetIsRefused) {
  EXPECT_THAT(complaint("preset = \"quick\"\n"), HasSubstr("case.toml:1: preset = \"quick\" is not allowed"));
  EXPECT_THAT(complaint("", {"preset=quick"}), HasSubstr("\"none\" or \"paper\""));
  EXPECT_THAT(complaint("[preset]\n"), HasSubstr("is not text in quotes"));
}

TEST(CaseFile, LaterOfTwoRivalsCounts) {
  Case c;
  apply_override(c, "compaction.time_step_absolute=0.03");
  apply_override(c, "compaction.time_step=0.01");
  EXPECT_FALSE(c.compaction.time_step_absolute.has_value());
  apply_override(c, "compaction.inertia=3");
  apply_override(c, "compaction.inertia_absolute=50");
  EXPECT_EQ(c.compaction.inertia, 1);
  EXPECT_EQ(parse_case(resolved_toml(c), "resolved.toml"), c);
}

TEST(CaseFile, OverrideIsCheckedLikeTheFile) {
  EXPECT_THAT(complaint("", {"contact.friction=-1"}), HasSubstr("--set: contact.friction = -1"));
  EXPECT_THAT(complaint("", {"contact.friction=-1"}), HasSubstr("0 <= friction"));
  EXPECT_THAT(complaint("", {"contact.friction=much"}), HasSubstr("not a number"));
  EXPECT_THAT(complaint("", {"contact.frction=1"}), HasSubstr("contact.friction"));
  EXPECT_THAT(complaint("", {"contact.friction"}), HasSubstr("table.key=value"));
  EXPECT_THAT(complaint("", {"friction=1"}), HasSubstr("table.key=value"));
  EXPECT_THAT(complaint("", {"compaction.time_step_absolute=5"}),
              HasSubstr("--set: compaction.time_step_abs"));
  EXPECT_THAT(complaint("", {"contact.friction=1\n[stop]\nsteps=3"}), HasSubstr("not a number"));
}

TEST(CaseFile, ConflictIsJudgedAfterAllOverrides) {
  EXPECT_NE(complaint("[compaction]\ntime_step_absolute = 1.0\n"), "");
  EXPECT_EQ(complaint("[compaction]\ntime_step_absolute = 1.0\n", {"compaction.time_step_absolute=0.03"}),
            "");
}

TEST(CaseFile, ValidateChecksACaseMadeByHand) {
  Case c;
  c.compaction.pressure = {};
  EXPECT_THROW(validate(c), InputError);
  c = Case{};
  c.contact.law = "hertz";
  EXPECT_THROW(validate(c), InputError);
  c = Case{};
  c.compute.threads = 5000;
  EXPECT_THROW(validate(c), InputError);
}

TEST(CaseFile, OneLargeSphereIsEnoughAmongManySmallOnes) {
  Case c;
  c.mixture = {.size_ratio = 40, .small_fraction = 0.3, .large = 1};
  EXPECT_NO_THROW(validate(c));
  c.mixture = {.large = 9};
  EXPECT_THROW(validate(c), InputError);
  c.compaction.cell = "fixed";
  EXPECT_NO_THROW(validate(c)) << "nothing is to jam in it";
}

TEST(CaseFile, CountsAndTimesOfThePaper) {
  EXPECT_EQ(small_count({.size_ratio = 40, .small_fraction = 0.292, .large = 1000}), 26395480.0);
  const Protocol protocol = protocol_of({});
  EXPECT_NEAR(*collision_time(law_of(protocol), equal_pair(1)), 1.62075, 1e-5);
  EXPECT_NEAR(time_step_of(protocol_of(parse_case("preset = \"paper\"", "paper.toml"))), 0.032415, 1e-6);
}

TEST(CaseFile, StartIsFoundBesideTheCaseFile) {
  const auto folder = std::filesystem::temp_directory_path() / ("furnas_start_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.toml") << "[start]\nfile = \"packing.data\"\n";
  EXPECT_THROW(read_case(folder / "case.toml"), InputError);
  std::ofstream(folder / "packing.data") << "x";
  EXPECT_EQ(read_case(folder / "case.toml").start.file, (folder / "packing.data").string());
  EXPECT_THROW(read_case(folder / "none.toml"), InputError);
  EXPECT_THROW(read_case(folder), InputError);
  std::filesystem::remove_all(folder);
}

TEST(CaseFile, AWholeNumberMayHaveAPointAndAnExponent) {
  EXPECT_EQ(parse_case("[stop]\nsteps = 1e6\n[mixture]\nlarge = 20.0\n", "a.toml").stop.steps, 1'000'000);
  EXPECT_EQ(parse_case("[mixture]\nlarge = 20.0\n", "a.toml").mixture.large, 20);
}

}  // namespace
}  // namespace furnas
