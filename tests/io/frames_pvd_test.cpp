#include "io/frames_pvd.h"

#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(FramesPvd, CanBeContinued) {
  const TemporaryFolder folder;
  std::vector<SavedFrame> frames;
  for (std::size_t k = 0; k < 3; ++k) {
    frames.push_back({0.1 * static_cast<double>(k), frame_file(k * 1000)});
    write_file(folder / "frames.pvd", frames_text(frames));
    EXPECT_EQ(read_frames(folder / "frames.pvd"), frames);
  }
  EXPECT_EQ(frames[1].file, "frames/packing_001000.vtp");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(FramesPvd, RefusesWhatIsNoCollection) {
  const TemporaryFolder folder;
  write_file(folder / "a.pvd", frames_text({{1.5, "a.vtp"}}));
  expect_refused(content(folder / "a.pvd"),
                 {
                     {"Collection", "PolyData", "not a ParaView collection"},
                     {"timestep=\"1.5\"", "timestep=\"x\"", "a.pvd:4: timestep is 'x'"},
                     {"file=", "name=", "needs file="},
                     {"</VTKFile>", "", "ends without"},
                 },
                 folder / "a.pvd", read_frames);
}

}  // namespace
}  // namespace furnas
