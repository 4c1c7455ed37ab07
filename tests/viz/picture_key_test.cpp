#include "viz/picture_key.h"

#include <gtest/gtest.h>

#include <array>

namespace furnas {
namespace {

std::array<int, 3> colour_at(const Pixels& picture, int x, int y) {
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(x));
  return {picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
}

TEST(PictureKey, BarRunsThroughTheColoursOfTheScale) {
  const Pixels key = drawn_key({.title = "contacts", .scale = ColourScale{0, 12}}, 800);
  ASSERT_EQ(key.height, height_of_key(800));
  const int y =
      static_cast<int>(2.15 * 0.019 * 800);  // the middle of the bar, from 0.15 to 0.85 of the width
  for (const double at : {0.1, 0.5, 0.9}) {
    const std::array<int, 3> found = colour_at(key, static_cast<int>(800 * (0.15 + 0.7 * at)), y);
    const Rgb wanted = graded(at);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], 3) << at;
  }
  EXPECT_EQ(colour_at(key, 40, y), (std::array<int, 3>{255, 255, 255})) << "beside the bar";
}

// OpenGL draws some 16 384 pixels along an edge, fewer than a wide key has when each pixel is drawn three
// times.
TEST(PictureKey, OfTheWidestPictureIsDrawn) {
  constexpr int width = 16384;
  const Pixels key = drawn_key({.title = "contacts", .scale = ColourScale{0, 12}}, width);
  ASSERT_EQ(key.width, width);
  const int y = static_cast<int>(2.15 * 0.019 * width);
  const std::array<int, 3> found = colour_at(key, static_cast<int>(width * (0.15 + 0.7 * 0.5)), y);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], graded(0.5)[c], 3);
}

}  // namespace
}  // namespace furnas
