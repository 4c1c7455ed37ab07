#include "io/outputs.h"

#include <set>

#include "io/formats.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

/// Writes the folder of a run that ended with this packing.
void write_folder(const Packing& packing, const TemporaryFolder& folder) {
  const Case c;
  Result result;
  result.measures.backbone_threshold = 3;
  write_outputs({c, packing, result}, folder / "");
}

TEST(Outputs, LeavesEveryFileOfTheTableAndNoOther) {
  const TemporaryFolder folder;
  const Packing p = random_packing(3);
  write_folder(p, folder);
  std::set<std::string> names;
  for (const Output& output : outputs()) {
    names.insert(output.file);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / output.file)) << output.file;
  }
  EXPECT_EQ(names, (std::set<std::string>{"cell.vtp", "contacts.vtp", "packing.extxyz", "packing.lammpstrj",
                                          "packing.vtp", "result.json"}));
  EXPECT_EQ(folder.files(), names.size());
}

/// The cell is as it was, tilts included, and every particle is where it was.
TEST(Outputs, EachPackingReadsBack) {
  const TemporaryFolder folder;
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Packing p = random_packing(seed);
    write_folder(p, folder);
    for (const char* file : {"packing.vtp", "packing.extxyz", "packing.lammpstrj"}) {
      SCOPED_TRACE(file);
      expect_same_packing(p, read_packing(folder / file));
    }
  }
}

TEST(Outputs, APackingWithoutContactsIsWrittenToo) {
  const TemporaryFolder folder;
  Packing p = random_packing(4);
  p.contacts.clear();
  write_folder(p, folder);
  EXPECT_GT(std::filesystem::file_size(folder / "contacts.vtp"), 100u);
}

}  // namespace
}  // namespace furnas
