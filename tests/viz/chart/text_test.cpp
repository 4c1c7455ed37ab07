#include "viz/chart/text.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

/// Lowered and raised runs begin with _ and ^.
std::vector<std::string> texts(const std::string& text) {
  std::vector<std::string> all;
  for (const TextRun& run : text_runs(text)) {
    std::string mark = run.lift < 0 ? "_" : run.lift > 0 ? "^" : "";
    all.push_back(mark.append(run.text));
  }
  return all;
}

using Texts = std::vector<std::string>;

TEST(ChartText, LowersAndRaisesALetterOrWhatStandsInBraces) {
  EXPECT_EQ(texts("plain φ"), Texts{"plain φ"});
  EXPECT_EQ(texts("F_n / μF_n"), (Texts{"F", "_n", " / μF", "_n"}));
  EXPECT_EQ(texts("10^{−4} k_n"), (Texts{"10", "^−4", " k", "_n"}));
  EXPECT_EQ(texts("φ_φ"), (Texts{"φ", "_φ"})) << "a letter may be several bytes";
  EXPECT_EQ(texts("x_"), Texts{"x_"});
  EXPECT_EQ(texts("x_{"), (Texts{"x", "_{"}));
  EXPECT_EQ(texts(""), Texts{});
}

/// Remembers where texts begin.
class Recorder final : public Canvas {
 public:
  void line(const std::vector<Spot>&, const Colour&, double) override {}
  void area(const std::vector<Spot>&, const Colour&) override {}
  void text(const Spot& left, const std::string&, double size, bool) override {
    places.push_back(left);
    sizes.push_back(size);
  }
  void clip(const std::optional<Box>&) override {}
  std::vector<Spot> places;
  std::vector<double> sizes;
};

TEST(ChartText, StandsAtItsPlace) {
  using Across = TextPlace::Across;
  using Along = TextPlace::Along;
  const double width = width_of_text("wide_{r}", 20);
  EXPECT_GT(width, 40);
  EXPECT_LT(width, 70);
  Recorder seen;
  write(seen, {100, 50}, "wide_{r}", 20, {Across::left, Along::bottom});
  write(seen, {100, 50}, "wide_{r}", 20, {Across::right, Along::bottom});
  write(seen, {100, 50}, "wide_{r}", 20, {Across::centre, Along::top, true});
  ASSERT_EQ(seen.places.size(), 6U);
  EXPECT_EQ(seen.places[0].x, 100);
  EXPECT_EQ(seen.places[0].y, 50);
  EXPECT_GT(seen.places[1].x, 100 + 0.6 * width);
  EXPECT_LT(seen.places[1].y, 50);
  EXPECT_LT(seen.sizes[1], seen.sizes[0]);
  EXPECT_DOUBLE_EQ(seen.places[2].x, 100 - width);
  // Upwards: along is y, and what is below stands to the right.
  EXPECT_DOUBLE_EQ(seen.places[4].y, 50 - width / 2);
  EXPECT_GT(seen.places[4].x, 100);
  EXPECT_GT(seen.places[5].x, seen.places[4].x);
}

}  // namespace
}  // namespace furnas
