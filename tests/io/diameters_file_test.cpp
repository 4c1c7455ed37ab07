#include "io/diameters_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

std::string refusal_of_list(const std::string& text) {
  const TemporaryFolder folder;
  write_file(folder / "d.txt", text);
  try {
    read_diameters(folder / "d.txt");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(DiametersFile, IsInUnitsOfItsSmallest) {
  const TemporaryFolder folder;
  write_file(folder / "d.txt", "# micrometres\n37.5\n\n75  # a remark\n 150\n37.5\n");
  const DiameterList list = read_diameters(folder / "d.txt");
  EXPECT_EQ(list.unit, 37.5);
  EXPECT_EQ(list.diameters, (std::vector<double>{1, 2, 4, 1}));
}

TEST(DiametersFile, NamesTheLineThatIsNoDiameter) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal_of_list("1\n0\n"), HasSubstr("d.txt:2: "));
  EXPECT_THAT(refusal_of_list("1\n-3\n"), HasSubstr("d.txt:2: "));
  EXPECT_THAT(refusal_of_list("1\nnan\n"), HasSubstr("d.txt:2: "));
  EXPECT_THAT(refusal_of_list("1 2\n"), HasSubstr("more than one number in a line"));
  EXPECT_THAT(refusal_of_list("# nothing\n"), HasSubstr("contains no diameter"));
}

}  // namespace
}  // namespace furnas
