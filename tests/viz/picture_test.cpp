#include "viz/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "tests/io/packings.h"
#include "viz/picture_key.h"
#include "viz/scene.h"
#include "viz/spheres.h"

namespace furnas {
namespace {

using testing::HasSubstr;
using Pixel = std::array<int, 4>;

/// A sheared cell with particles on a lattice of n^3 places, large and small in turn.
Packing lattice(int n, double large, double small) {
  Packing packing;
  packing.cell.edges = {10, 9, 8, 0.8, -0.5, 1.5};
  packing.resize(static_cast<std::size_t>(n * n * n));
  for (int k = 0; k < n * n * n; ++k) {
    const int x = k % n, y = k / n % n, z = k / n / n;
    const auto at = static_cast<std::size_t>(k);
    packing.fraction[at] = to_fraction({(x + 0.5) / n, (y + 0.5) / n, (z + 0.5) / n});
    packing.species[at] = (x + y + z) % 2 ? Species::small : Species::large;
    packing.radius[at] = packing.species[at] == Species::large ? large : small;
  }
  return packing;
}

Packing one_sphere() {
  Packing packing;
  packing.cell.edges = {10, 10, 10, 0, 0, 0};
  packing.resize(1);
  packing.radius[0] = 2;
  packing.fraction[0] = to_fraction({0.3, 0.4, 0.7});
  return packing;
}

Pixel pixel(const Pixels& picture, int x, int y) {
  Pixel result;
  for (int c = 0; c < 4; ++c)
    result[c] = picture.rgba[static_cast<std::size_t>(4 * (y * picture.width + x) + c)];
  return result;
}

Pixel pixel(const Pixels& picture, const View& view, const Vec3<double>& point) {
  const auto [x, y] = view.project(point);
  return pixel(picture, static_cast<int>((1 + x) / 2 * picture.width),
               static_cast<int>((1 + y) / 2 * picture.height));
}

bool is_background(const Pixel& p) { return p[3] == 255 && std::min({p[0], p[1], p[2]}) == 255; }
bool is_grey(const Pixel& p) {
  return p[3] == 255 && p[0] > 70 && p[0] < 254 && std::abs(p[0] - p[1]) < 8 && std::abs(p[0] - p[2]) < 8;
}
bool is_gold(const Pixel& p) { return p[3] == 255 && p[0] > 60 && p[0] > p[1] && p[1] > 2 * p[2]; }
bool is_dark_blue(const Pixel& p) { return p[3] == 255 && p[0] < 70 && p[0] < p[2]; }

/// What a picture of the packing shows.
Drawing drawing(const Packing& packing, bool cell) {
  Drawing d{spheres_of(packing, std::vector<Rgb>(packing.size()), {1, 1, 1}, {}), {}, {}};
  if (cell) d.frame = CellFrame{packing.cell};
  return d;
}

/// The share of pixels that are so.
template <class Condition>
double share(const Pixels& picture, Condition condition) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) count += condition(pixel(picture, x, y));
  return double(count) / (picture.width * picture.height);
}

double brightness(const Pixels& picture) {
  double sum = 0;
  for (std::size_t k = 0; k < picture.rgba.size(); ++k) sum += k % 4 == 3 ? 0 : picture.rgba[k];
  return sum / static_cast<double>(picture.rgba.size());
}

TEST(Picture, FileShowsBothSpeciesOnWhite) {
  const TemporaryFolder folder;
  const auto path = folder / "packing.png";
  render_picture(lattice(4, 1.1, 0.9), path, {.width = 300, .height = 200});
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  ASSERT_EQ(image.GetDimensions()[0], 300);
  ASSERT_EQ(image.GetDimensions()[1], 200);
  ASSERT_EQ(image.GetNumberOfScalarComponents(), 3);

  Pixels read{300, 200, {}};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      for (int c = 0; c < 3; ++c)
        read.rgba.push_back(static_cast<std::uint8_t>(image.GetScalarComponentAsDouble(x, y, 0, c)));
      read.rgba.push_back(255);
    }
  EXPECT_GT(share(read, is_grey), 0.10);
  EXPECT_GT(share(read, is_gold), 0.08);
  EXPECT_GT(share(read, is_background), 0.40);  // the block fills the height, not the width
  EXPECT_LT(share(read, is_background), 0.75);
  EXPECT_EQ(read.rgba, render(lattice(4, 1.1, 0.9), {.width = 300, .height = 200}).rgba);
}

TEST(Picture, BlockFillsTheFrame) {
  const Pixels picture = render(lattice(4, 1.1, 0.9), {.width = 240, .height = 240});
  int left = 240, right = 0, bottom = 240, top = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x)
      if (!is_background(pixel(picture, x, y))) {
        left = std::min(left, x), right = std::max(right, x);
        bottom = std::min(bottom, y), top = std::max(top, y);
      }
  EXPECT_GE(std::min(left, bottom), 3);
  EXPECT_LE(std::max(right, top), 236);
  EXPECT_GE(std::max(right - left, top - bottom), 228);
  EXPECT_GE(std::min(right - left, top - bottom), 190);
}

TEST(Picture, TransparentOutsideAndOpaqueInside) {
  const TemporaryFolder folder;
  const auto path = folder / "packing.png";
  render_picture(lattice(3, 1.6, 1.5), path, {.width = 120, .height = 120, .transparent = true});
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  ASSERT_EQ(image.GetNumberOfScalarComponents(), 4);
  for (const int x : {0, 119})
    for (const int y : {0, 119}) EXPECT_EQ(image.GetScalarComponentAsDouble(x, y, 0, 3), 0);
  EXPECT_EQ(image.GetScalarComponentAsDouble(60, 60, 0, 3), 255);
}

TEST(Picture, TransparentEdgesKeepTheirColour) {
  const Pixels picture =
      render(one_sphere(), {.width = 120, .height = 120, .transparent = true, .cell = false});
  int partly = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      const Pixel p = pixel(picture, x, y);
      if (p[3] == 0 || p[3] == 255) continue;
      ++partly;
      EXPECT_GT(p[0], 50);  // nothing of the black behind it
    }
  EXPECT_GT(partly, 100);
}

TEST(Picture, LoneSphereIsADiscThatFillsTheFrame) {
  const int side = 300;
  const Pixels picture = render(one_sphere(), {.width = side, .height = side, .cell = false});
  const double radius = 0.96 * side / 2;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double distance = std::hypot(x + 0.5 - side / 2.0, y + 0.5 - side / 2.0);
      if (std::abs(distance - radius) < 1.5) continue;
      const Pixel p = pixel(picture, x, y);
      ASSERT_TRUE(distance < radius ? is_grey(p) : is_background(p)) << x << ' ' << y;
    }
}

TEST(Picture, SphereIsWhereTheProjectionSays) {
  Packing packing = one_sphere();
  packing.species[0] = Species::small;  // gold, to tell it from the smoothed edges of the cell
  const Pixels picture = render(packing, {.width = 300, .height = 300});
  const View view = view_of(drawing(packing, true), 1);
  double count = 0, x_sum = 0, y_sum = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x)
      if (is_gold(pixel(picture, x, y))) ++count, x_sum += x + 0.5, y_sum += y + 0.5;
  const auto [x, y] = view.project(packing.position(0));
  const double depth = dot(view.eye - packing.position(0), view.toward);
  EXPECT_NEAR(std::sqrt(count / std::numbers::pi), packing.radius[0] / view.pixel(depth, 300), 1);
  EXPECT_NEAR(x_sum / count, (1 + x) * 150, 1);
  EXPECT_NEAR(y_sum / count, (1 + y) * 150, 1);
}

TEST(Picture, EachParticleHasTheColourOfItsSpecies) {
  const Packing packing = lattice(2, 0.7, 0.5);  // so sparse that no sphere hides another's middle
  const PictureOptions options{.width = 300, .height = 240, .cell = false};
  const Pixels picture = render(packing, options);
  const View view = view_of(drawing(packing, false), 300.0 / 240);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const Pixel p = pixel(picture, view, packing.position(k));
    EXPECT_TRUE(packing.species[k] == Species::large ? is_grey(p) : is_gold(p)) << "particle " << k;
  }
}

TEST(Picture, EdgesOfTheCellAreDrawnOnRequest) {
  Packing packing = one_sphere();
  packing.cell.edges = {10, 9, 8, 0.8, -0.5, 1.5};
  const View view = view_of(drawing(packing, true), 1);
  const Pixels with = render(packing, {.width = 400, .height = 400});
  for (const Vec3<double>& s :
       {Vec3{0.75, 0.0, 0.0}, Vec3{1.0, 0.5, 0.0}, Vec3{1.0, 1.0, 0.5}, Vec3{0.5, 0.0, 1.0}})
    EXPECT_TRUE(is_dark_blue(pixel(with, view, packing.cell.edges * s))) << s.x << ' ' << s.y << ' ' << s.z;
  EXPECT_EQ(share(render(packing, {.width = 400, .height = 400, .cell = false}), is_dark_blue), 0);
}

TEST(Picture, AmbientOcclusionDarkensGapsButNotALoneSphere) {
  const auto ratio = [](const Packing& packing) {
    PictureOptions options{.width = 200, .height = 200, .cell = false};
    const double with = brightness(render(packing, options));
    options.ambient_occlusion = false;
    return with / brightness(render(packing, options));
  };
  EXPECT_LT(ratio(lattice(5, 0.9, 0.9)), 0.95);
  EXPECT_GT(ratio(lattice(5, 0.9, 0.9)), 0.60);
  EXPECT_NEAR(ratio(one_sphere()), 1, 0.03);
}

template <class Error = InputError, class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Two spheres of the middle that press each other, and one apart.
Packing pair() {
  Packing packing;
  packing.cell.edges = {10, 10, 10, 0, 0, 0};
  packing.resize(3);
  packing.radius = {1, 1, 1};
  packing.fraction = {to_fraction({0.41, 0.5, 0.5}), to_fraction({0.59, 0.5, 0.5}),
                      to_fraction({0.2, 0.2, 0.2})};
  Contact c;
  c.i = 0, c.j = 1;
  c.branch = {-1.8, 0, 0};
  c.force = {-0.2, 0, 0};
  packing.contacts = {c};
  return packing;
}

TEST(Picture, ChainsShowWhatPresses) {
  const PictureOptions options{.width = 300, .height = 300, .style = PictureStyle::chains};
  const Packing packing = pair();
  const Pixels picture = render(packing, options);
  const View view = view_of(drawing(packing, true), 1);
  const auto is_yellow = [](const Pixel& p) {
    return p[0] > 110 && p[1] > 100 && p[2] < 110 && p[1] > 1.5 * p[2];
  };
  const auto is_veil = [](const Pixel& p) { return p[0] > 200 && p[0] < 255 && std::abs(p[0] - p[2]) < 12; };
  EXPECT_TRUE(is_yellow(pixel(picture, view, packing.cell.edges * Vec3<double>{0.5, 0.5, 0.5})));
  EXPECT_TRUE(is_veil(pixel(picture, view, packing.position(2))));
  EXPECT_TRUE(is_background(pixel(picture, 1, 1)));
}

TEST(Picture, ChainsNeedContacts) {
  EXPECT_THAT(refusal([] { render(one_sphere(), {.style = PictureStyle::chains}); }),
              HasSubstr("no contacts"));
}

TEST(Picture, ASliceLeavesTheRestOut) {
  PictureOptions options{.width = 200, .height = 200, .cell = false, .slice = Slice{2, 0.0, 0.5}};
  const Packing packing = lattice(2, 0.7, 0.5);
  options.room = room_of(packing);
  const Pixels half = render(packing, options);
  options.slice.reset();
  const Pixels whole = render(packing, options);
  const double ratio = (1 - share(half, is_background)) / (1 - share(whole, is_background));
  EXPECT_NEAR(ratio, 0.5, 0.05);
  options.slice = Slice{2, 0.45, 0.55};
  EXPECT_THAT(refusal([&] { render(packing, options); }),
              HasSubstr("the slice holds the centre of no particle"));
}

TEST(Picture, ATurnGoesAroundOnOneScale) {
  PictureOptions options{.width = 100, .height = 100, .cell = false};
  const Packing packing = lattice(2, 0.7, 0.5);
  options.room = room_of(packing);
  const Pixels front = render(packing, options);
  options.turn = 90;
  EXPECT_NE(render(packing, options).rgba, front.rgba);
  options.turn = 360;
  EXPECT_EQ(render(packing, options).rgba, front.rgba);
}

TEST(Picture, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  render(one_sphere(), {.width = 20, .height = 20});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Picture, RefusesWhatCannotBeDrawn) {
  EXPECT_THAT(refusal([] { render(Packing{}); }), HasSubstr("no particles"));
  EXPECT_THAT(refusal([] { render(one_sphere(), {.width = 0}); }), HasSubstr("0 x 2000 pixels"));
  EXPECT_THAT(refusal([] { render(one_sphere(), {.height = 1 << 20}); }),
              HasSubstr("each side must be 1 to"));
}

TEST(Picture, NamesThePathThatCannotBeWritten) {
  const TemporaryFolder folder;
  const PictureOptions options{.width = 20, .height = 20};
  const auto lost = folder / "missing" / "packing.png";
  EXPECT_THAT(refusal<OutputError>([&] { render_picture(one_sphere(), lost, options); }),
              testing::AllOf(HasSubstr(lost.string()), HasSubstr("No such file")));
  const auto taken = folder / "taken.png";
  std::filesystem::create_directory(taken);
  EXPECT_THAT(refusal<OutputError>([&] { render_picture(one_sphere(), taken, options); }),
              HasSubstr(taken.string()));
  EXPECT_TRUE(std::filesystem::is_empty(taken));
  EXPECT_FALSE(std::filesystem::exists(taken.string() + ".tmp"));
}

TEST(Picture, ExtensionNamesTheFormat) {
  const TemporaryFolder folder;
  const PictureOptions options{.width = 20, .height = 20};
  render_picture(one_sphere(), folder / "a.jpg", options);
  vtkNew<vtkJPEGReader> reader;
  EXPECT_NE(reader->CanReadFile((folder / "a.jpg").c_str()), 0);
  EXPECT_THAT(refusal([&] { render_picture(one_sphere(), folder / "a.gif", options); }),
              HasSubstr("a.gif: its extension names no format of pictures; allowed: .png, .jpg, .jpeg"));
  const PictureOptions clear{.width = 20, .height = 20, .transparent = true};
  EXPECT_THAT(refusal([&] { render_picture(one_sphere(), folder / "b.jpg", clear); }),
              HasSubstr("a JPEG cannot be transparent"));
  EXPECT_FALSE(std::filesystem::exists(folder / "b.jpg"));
}

TEST(Picture, KeyOfATransparentPictureHasNoBackground) {
  PictureOptions options{.width = 500, .height = 500, .key = true, .colouring = Colouring::coordination};
  const Pixels opaque = render(one_sphere(), options);
  options.transparent = true;
  const Pixels clear = render(one_sphere(), options);
  std::size_t letters = 0;
  for (std::size_t k = 0; k < 4u * 500 * static_cast<std::size_t>(height_of_key(500)); k += 4) {
    const int opacity = clear.rgba[k + 3];
    for (std::size_t c = k; c < k + 3; ++c)  // laid over white it looks as before
      ASSERT_NEAR((clear.rgba[c] * opacity + 255 * (255 - opacity)) / 255.0, opaque.rgba[c], 1.01) << k;
    letters += opacity > 128;
  }
  EXPECT_EQ(clear.rgba[3], 0) << "the corner";
  EXPECT_GT(letters, 100u);
}

TEST(Picture, KeyStandsBelowThePacking) {
  const PictureOptions with{.width = 500, .height = 500, .key = true, .colouring = Colouring::coordination};
  PictureOptions without = with;
  without.key = false;
  without.height = 500 - height_of_key(500);
  const Pixels key = drawn_key(coloured(one_sphere(), Colouring::coordination, 4).legend, 500);
  const Pixels all = render(one_sphere(), with), packing = render(one_sphere(), without);
  ASSERT_EQ(all.rgba.size(), 4u * 500 * 500);
  const auto end_of_key = all.rgba.begin() + static_cast<std::ptrdiff_t>(key.rgba.size());
  EXPECT_TRUE(std::equal(all.rgba.begin(), end_of_key, key.rgba.begin(), key.rgba.end()));
  EXPECT_TRUE(std::equal(end_of_key, all.rgba.end(), packing.rgba.begin(), packing.rgba.end()));
  EXPECT_EQ(render(one_sphere(), {.width = 60, .height = 60, .key = true}).rgba,
            render(one_sphere(), {.width = 60, .height = 60}).rgba)
      << "no room for letters";
}

TEST(Room, HoldsEveryCopyOfTheCell) {
  Packing packing = one_sphere();
  packing.radius[0] = 4;
  packing.fraction[0] = to_fraction({0.95, 0.5, 0.5});
  EXPECT_NEAR(room_of(packing), std::sqrt(75.0), 1e-12) << "the corners of the cell";
  EXPECT_NEAR(room_of(packing, {3, 1, 1}), 18.5, 1e-12) << "the last of three spheres: 29.5 - 15 + 4";
}

}  // namespace
}  // namespace furnas
