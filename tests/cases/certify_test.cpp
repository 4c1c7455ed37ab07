#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/checkpoint.h"
#include "io/formats.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// One of the jammed packings of 200 equal spheres that tests/data/README.md describes, as a run would save
/// it.
Checkpoint jammed_packing(const std::string& friction) {
  const Json json = Json::parse(content(test_data("jammed.mu" + friction + ".json")));
  Checkpoint checkpoint;
  checkpoint.case_text = "[contact]\nfriction = " + friction + "\n[compaction]\npressure = 1e-4\n";
  Packing& p = checkpoint.packing;
  const std::vector<double> h = json["edges"];
  p.cell.edges = {h[0], h[1], h[2], h[3], h[4], h[5]};
  p.resize(json["fraction"].size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Json& s = json["fraction"][k];
    p.fraction[k] = {s[0], s[1], s[2]};
    p.radius[k] = 0.5;
    p.mass[k] = std::numbers::pi / 6;
  }
  for (const Json& row : json["contacts"]) {
    Contact c;
    c.i = row[0], c.j = row[1];
    c.image = {row[2], row[3], row[4]};
    c.history = {row[5], row[6], row[7]};
    Vec3<double> d = nearest_difference(p.fraction[c.i], p.fraction[c.j]);
    d += {double(c.image[0]), double(c.image[1]), double(c.image[2])};
    c.branch = p.cell.edges * d;
    c.overlap = 1 - norm(c.branch);
    p.contacts.push_back(c);
  }
  return checkpoint;
}

/// A jammed packing, before and after a test has laid hands on it.
class Certified {
 public:
  explicit Certified(const std::string& friction) : checkpoint(jammed_packing(friction)) {}

  /// What the command says of the packing as it is now.
  Answer certify(const std::vector<std::string>& options = {}) const {
    write_checkpoint(checkpoint, path("a.checkpoint"));
    std::vector<std::string> arguments{"certify", path("a.checkpoint")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return furnas(arguments);
  }
  Json json() const { return Json::parse(content(path("certificate.json"))); }
  std::vector<std::string> failed(const std::vector<std::string>& options = {}) const {
    const Answer answer = certify(options);
    const std::vector<std::string> parts = json()["failed"];
    EXPECT_EQ(answer.code, parts.empty() ? ExitCode::done : ExitCode::not_certified) << answer.err;
    EXPECT_EQ(content(path("certificate.txt")), answer.out);
    for (const std::string& part : parts) EXPECT_THAT(answer.out, HasSubstr("FAILED  " + part));
    return parts;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  Packing& packing() { return checkpoint.packing; }
  Checkpoint checkpoint;

 private:
  TemporaryFolder folder_;
};

/// Without a particle and all that touches it.
void take_out(Packing& p, std::uint32_t gone) {
  const auto drop = [&](auto& list) { list.erase(list.begin() + gone); };
  drop(p.species), drop(p.radius), drop(p.mass), drop(p.fraction), drop(p.image);
  drop(p.velocity), drop(p.spin), drop(p.force), drop(p.torque);
  p.order.clear();
  std::erase_if(p.contacts, [&](const Contact& c) { return c.i == gone || c.j == gone; });
  for (Contact& c : p.contacts) c.i -= c.i > gone, c.j -= c.j > gone;
}

/// The contact with the largest overlap.
Contact& strongest(Packing& p) {
  return *std::max_element(p.contacts.begin(), p.contacts.end(),
                           [](const Contact& a, const Contact& b) { return a.overlap < b.overlap; });
}

TEST(Certify, PassesJammedPackings) {
  for (const char* friction : {"0", "0.3"}) {
    Certified packing(friction);
    EXPECT_THAT(packing.failed(), IsEmpty()) << friction;
    const Json json = packing.json();
    EXPECT_EQ(json["passed"], true);
    EXPECT_EQ(json["contacts_not_in_the_list"], 0);
    EXPECT_EQ(json["listed_contacts_that_are_open"], 0);
    EXPECT_GT(json["bulk_modulus"], 0.15);
    EXPECT_LT(json["bulk_modulus"], 0.35);
    EXPECT_GT(json["shear_modulus"], 0);
    EXPECT_EQ(json["parts"].size(), 8u);
    EXPECT_EQ(json["eigenvalues"].size(), 6u);
  }
}

// Nothing that the run has summed up is read: forces, velocities and stress may say what they like.
TEST(Certify, BelievesNothingButPositionsAndHistories) {
  Certified packing("0.3");
  packing.certify();
  const Json expected = packing.json();
  for (auto& f : packing.packing().force) f = {1, 2, 3};
  for (auto& v : packing.packing().velocity) v = {1, 2, 3};
  for (Contact& c : packing.packing().contacts) c.force = {1, 2, 3}, c.overlap = 1, c.sliding = !c.sliding;
  packing.packing().stress.contacts.setZero();
  packing.certify();
  EXPECT_EQ(packing.json(), expected);
}

// 1e-3 is several times the mean overlap: nearly all contacts open.
TEST(Certify, RefusesAnExpandedPacking) {
  for (const char* friction : {"0", "0.3"}) {
    Certified packing(friction);
    Triangle& h = packing.packing().cell.edges;
    h = product({1.001, 1.001, 1.001, 0, 0, 0}, h);
    EXPECT_THAT(packing.failed(), testing::AllOf(Contains("backbone"), Contains("stress"))) << friction;
  }
}

TEST(Certify, RefusesAPackingWithoutASphereOfItsBackbone) {
  for (const char* friction : {"0", "0.3"}) {
    Certified packing(friction);
    take_out(packing.packing(), strongest(packing.packing()).i);
    EXPECT_THAT(packing.failed(), Contains("force balance")) << friction;
  }
}

TEST(Certify, RefusesTangentialForcesBeyondTheirCone) {
  Certified packing("0.3");
  Contact& c = strongest(packing.packing());
  // 5 % above the cone.
  c.history *= 1.05 * 0.3 * c.overlap / norm(c.history);
  EXPECT_THAT(packing.failed(), Contains("friction"));
  EXPECT_THAT(packing.failed({"--cone-excess", "1"}), testing::Not(Contains("friction")));
}

TEST(Certify, RefusesARunThatStoppedEarly) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=5000"}).code, ExitCode::budget_spent);
  const Answer answer = furnas({"certify", runs.path("a")});
  EXPECT_EQ(answer.code, ExitCode::not_certified) << answer.out;
  const Json json = Json::parse(content(runs.path("a/certificate.json")));
  EXPECT_THAT(std::vector<std::string>(json["failed"]), Contains("force balance"));
  EXPECT_TRUE(fs::exists(runs.path("a/certificate.txt")));
}

// A pressure that is 1 % higher than that of the case: the stress alone tells.
TEST(Certify, RefusesAnotherPressure) {
  Certified packing("0");
  std::string& text = packing.checkpoint.case_text;
  const auto at = text.find("\npressure = ");
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, text.find('\n', at + 1) - at, "\npressure = 1.01e-4");
  EXPECT_THAT(packing.failed(), ElementsAre("stress"));
}

TEST(Certify, TakesItsLimitsFromTheCaseOrFromOptions) {
  Certified packing("0.3");
  EXPECT_THAT(packing.failed({"--force-imbalance", "1e-9"}), ElementsAre("force balance"));
  EXPECT_THAT(packing.failed({"--stress-error", "1e-9"}), ElementsAre("stress"));
  EXPECT_THAT(packing.failed({"--eigenvalues", "3"}), IsEmpty());
  EXPECT_EQ(packing.json()["eigenvalues"].size(), 3u);
}

TEST(Certify, SaysWhatItCannotUse) {
  const Runs runs;
  write_file(runs.path("a.txt"), "hello\n");
  fs::create_directory(runs.path("empty"));
  EXPECT_EQ(furnas({"certify", runs.path("a.txt")}).code, ExitCode::bad_case);
  EXPECT_EQ(furnas({"certify", runs.path("none")}).code, ExitCode::bad_case);
  EXPECT_EQ(furnas({"certify", runs.path("empty")}).code, ExitCode::bad_case);
  Certified packing("0");
  const Answer answer = packing.certify({"--out", runs.path("a.txt")});
  EXPECT_EQ(answer.code, ExitCode::bad_case);
  EXPECT_THAT(answer.err, HasSubstr("cannot be made"));
  write_packing(packing.packing(), "vtp", runs.path("a.vtp"));
  EXPECT_THAT(furnas({"certify", runs.path("a.vtp")}).err, HasSubstr("it contains no case"));
}

TEST(Certify, SaysThatAFileHasNoHistories) {
  const Runs runs;
  Certified packing("0.3");
  write_packing(packing.packing(), "extxyz", runs.path("a.xyz"));
  const std::vector<std::string> command{"certify", runs.path("a.xyz"), "--pressure", "1e-3"};
  const auto with_friction = [&](const std::string& friction) {
    auto words = command;
    words.insert(words.end(), {"--friction", friction});
    return furnas(words).out;
  };
  const std::string said = "the file has no tangential histories";
  EXPECT_THAT(with_friction("0.3"),
              AllOf(HasSubstr(said), HasSubstr("this result says nothing about the packing")));
  EXPECT_THAT(with_friction("0"), Not(HasSubstr(said)));
  EXPECT_THAT(packing.certify().out, Not(HasSubstr(said)));
}

TEST(Certify, MakesTheFolderThatIsNamed) {
  const Runs runs;
  Certified packing("0");
  EXPECT_EQ(packing.certify({"--out", runs.path("seen/here")}).code, ExitCode::done);
  EXPECT_TRUE(fs::exists(runs.path("seen/here/certificate.json")));
  EXPECT_FALSE(fs::exists(packing.path("certificate.json")));
}

TEST(Certify, HasNoMotionToSetGoingInAStablePacking) {
  Certified packing("0");
  const Answer answer = packing.certify({"--kick", packing.path("kicked.toml")});
  EXPECT_EQ(answer.code, ExitCode::done);
  EXPECT_THAT(answer.out, HasSubstr("--kick: the packing passes"));
  EXPECT_FALSE(fs::exists(packing.path("kicked.toml")));
  const Answer other = packing.certify({"--kick", packing.path("kicked.vtp")});
  EXPECT_EQ(other.code, ExitCode::bad_case);
  EXPECT_THAT(other.err, HasSubstr("allowed: a name that ends in .toml"));
  const Answer third = packing.certify({"--kick", packing.path("a.toml")});
  EXPECT_EQ(third.code, ExitCode::bad_case);
  EXPECT_THAT(third.err, HasSubstr("a.checkpoint exists and is not overwritten"));
}

// A packing whose sliding contacts let a motion grow e-fold in ten time units. Its run goes on from the kick
// to a stable rest, at about the same phi.
TEST(Certify, SetsGoingWhatIsNotStable) {
  const Runs runs(
      "[mixture]\nsize_ratio = 3.0\nsmall_fraction = 0.3\nlarge = 30\nseed = 7\n[output]\npicture = "
      "\"none\"\n");
  ASSERT_EQ(runs.run("a").code, ExitCode::done);
  Answer answer = furnas({"certify", runs.path("a"), "--kick", runs.path("a_kicked.toml")});
  ASSERT_EQ(answer.code, ExitCode::not_certified) << answer.out;
  EXPECT_THAT(answer.out, HasSubstr("1 motion set going"));
  std::string name = "a";
  for (int round = 0; round < 4 && answer.code == ExitCode::not_certified; ++round) {
    const std::string kicked = runs.path(name + "_kicked.toml");
    name += "_next";
    ASSERT_EQ(furnas({"run", kicked, "--out", runs.path(name)}).code, ExitCode::done);
    answer = furnas({"certify", runs.path(name), "--kick", runs.path(name + "_kicked.toml")});
  }
  EXPECT_EQ(answer.code, ExitCode::done) << answer.out;
  EXPECT_GE(runs.result(name)["quenches"], 20);
  EXPECT_NEAR(runs.result(name)["phi_J"], double(runs.result("a")["phi_J"]), 1e-3);
}

/// Runs the case of the program's defaults with `set` in its place and certifies what comes out.
void expect_certified(const std::vector<std::string>& set) {
  const Runs runs("[output]\npicture = \"none\"\n");
  const Answer run = runs.run("a", set);
  ASSERT_EQ(run.code, ExitCode::done) << run.out << run.err;
  const Answer answer = furnas({"certify", runs.path("a")});
  EXPECT_EQ(answer.code, ExitCode::done) << answer.out;
}

// N 1000, as in the cases of the tree, and mixtures.
TEST(NightlyCertify, PassesWhatTheProgramMakes) {
  expect_certified({"contact.friction=0.3"});
  expect_certified({"contact.friction=0"});
  for (const char* friction : {"contact.friction=0.3", "contact.friction=0"})
    expect_certified({friction, "mixture.size_ratio=3", "mixture.small_fraction=0.3", "mixture.large=60"});
}

// N 10 000. One of its motions no spring resists: docs/developer/decisions/limits-of-the-certificate.md.
TEST(NightlyCertify, PassesTenThousandSpheres) {
  expect_certified({"contact.friction=0.3", "mixture.large=10000"});
}

// Without friction the softest modes of many spheres take long to settle: a million steps.
TEST(NightlyCertify, PassesThreeThousandSpheresWithoutFriction) {
  expect_certified({"contact.friction=0", "mixture.large=3000", "stop.steps=5_000_000"});
}

}  // namespace
}  // namespace furnas
