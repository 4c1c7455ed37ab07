#include "io/certificate_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/io/packings.h"

namespace furnas {
namespace {

using Json = nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

Certificate two_parts() {
  Certificate c;
  c.particles = 10, c.backbone = 8, c.contacts = 30;
  c.bulk_modulus = NAN;
  c.eigenvalues = {0.25, 0.5};
  c.parts = {{"balance", "Is it?", Proves::necessary, {at_most("sum", 2, 1), told("count", 7)}, "so-so"},
             {"modes", "Do they?", Proves::sufficient, {at_least("lowest", 0.25, 0)}, ""}};
  return c;
}

TEST(CertificateFile, TellsEachPart) {
  const TemporaryFolder folder;
  write_certificate(two_parts(), {}, {"a run"}, folder / "");
  const Json json = Json::parse(content(folder / "certificate.json"));
  EXPECT_EQ(json["of"], "a run");
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["failed"], Json({"balance"}));
  EXPECT_TRUE(json["bulk_modulus"].is_null()) << "JSON knows no NaN";
  const Json& balance = json["parts"][0];
  EXPECT_EQ(balance["proves"], "necessary only");
  EXPECT_EQ(balance["findings"][0],
            Json({{"name", "sum"}, {"value", 2.0}, {"at_most", 1.0}, {"holds", false}}));
  EXPECT_EQ(balance["findings"][1], Json({{"name", "count"}, {"value", 7.0}}));
  EXPECT_EQ(json["parts"][1]["proves"], "sufficient to first order");
  EXPECT_EQ(json["parts"][1]["passed"], true);

  const std::string text = content(folder / "certificate.txt");
  EXPECT_THAT(text, HasSubstr("Certificate of a run"));
  EXPECT_THAT(text, HasSubstr("FAILED  balance (necessary)\n"));
  EXPECT_THAT(text, HasSubstr("passed  modes (sufficient to first order)"));
  EXPECT_THAT(text, HasSubstr("so-so"));
  EXPECT_THAT(text, HasSubstr("not certified: balance failed"));
  EXPECT_EQ(text, certificate_text(two_parts(), {}, {"a run"}));
}

Certificate all_passed(Proves stability) {
  Certificate c = two_parts();
  c.parts[0].findings = {at_most("sum", 0.5, 1)};
  c.parts[1].proves = stability;
  c.live_backbone = 7;
  return c;
}

TEST(CertificateFile, BeginsWithWhatIsProvenAndWhatIsNot) {
  const std::string stable = certificate_text(all_passed(Proves::sufficient), {}, {"a run"});
  EXPECT_THAT(stable, HasSubstr("Certificate of a run\n\nForces balance at the applied pressure within the "
                                "limits below. Proven, to first order: "));
  EXPECT_THAT(stable, HasSubstr("Not proven: what large motions"));
  const std::string sliding = certificate_text(all_passed(Proves::necessary), {}, {"a run"});
  EXPECT_THAT(sliding, HasSubstr("Not proven: that every small motion costs energy"));
  Certificate slides = two_parts();
  slides.parts[0].proves = Proves::neither;
  EXPECT_THAT(certificate_text(slides, {}, {"a run"}),
              AllOf(HasSubstr("a jammed packing passes every part that is necessary."),
                    HasSubstr("FAILED  balance (neither necessary nor sufficient)\n")));
  EXPECT_THAT(certificate_text(two_parts(), {}, {"a run"}),
              HasSubstr("Certificate of a run\n\nNot certified: balance failed"));
}

TEST(CertificateFile, NamesTheRuleOfEachCount) {
  const std::string text = certificate_text(all_passed(Proves::sufficient), {}, {"a run"});
  EXPECT_THAT(text, HasSubstr("8 of them in the backbone with 30 contacts (every overlap counts)"));
  EXPECT_THAT(text, HasSubstr("by the rule of a run (live contacts only) 7"));
}

// A number that is none keeps no limit.
TEST(CertificateFile, AFindingThatIsNoNumberFails) {
  EXPECT_FALSE(at_most("x", NAN, 1).holds());
  EXPECT_FALSE(at_least("x", NAN, 1).holds());
  EXPECT_TRUE(told("x", NAN).holds());
  EXPECT_TRUE(at_most("x", 1, 1).holds());
  EXPECT_FALSE(at_least("x", 0.5, 1).holds());
}

}  // namespace
}  // namespace furnas
