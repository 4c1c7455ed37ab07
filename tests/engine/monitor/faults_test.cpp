#include "engine/monitor/faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "engine/monitor/stability.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using testing::HasSubstr;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string fault_after(const std::function<void(Packing&)>& change) {
  Packing p = jammed();
  p.step = 3000;
  change(p);
  return fault_of(p, jammed_model());
}

TEST(FaultOf, AJammedPackingHasNone) {
  EXPECT_EQ(fault_after([](Packing&) {}), "");
}

TEST(FaultOf, NamesWhatIsNotFinite) {
  for (double bad : {nan, infinity, -infinity}) {
    const std::pair<const char*, std::vector<Vec3<double>> Packing::*> fields[] = {
        {"velocity", &Packing::velocity},
        {"spin", &Packing::spin},
        {"force", &Packing::force},
        {"torque", &Packing::torque}};
    for (const auto& [name, field] : fields)
      EXPECT_EQ(fault_after([&](Packing& p) { (p.*field)[41].y = bad; }),
                "the " + std::string(name) + " of particle 42 is not finite at step 3000");
    EXPECT_THAT(fault_after([&](Packing& p) { p.cell.edges.yz = bad; }), HasSubstr("an edge of the cell"));
    EXPECT_THAT(fault_after([&](Packing& p) { p.cell.rate.xx = bad; }), HasSubstr("an edge of the cell"));
    const Contact c = jammed().contacts[7];
    const std::string pair = std::to_string(c.i + 1) + " and " + std::to_string(c.j + 1);
    EXPECT_THAT(fault_after([&](Packing& p) { p.contacts[7].force.z = bad; }), HasSubstr(pair));
    EXPECT_THAT(fault_after([&](Packing& p) { p.contacts[7].history.x = bad; }), HasSubstr(pair));
  }
}

TEST(FaultOf, SeesAnOverfullCell) {
  EXPECT_THAT(fault_after([](Packing& p) { p.cell.edges.zz *= 0.3; }), HasSubstr("of the cell at step 3000"));
}

TEST(FaultOf, SeesSpheresThatRanThroughEachOther) {
  const auto overlap_of = [](double share) {
    return fault_after([&](Packing& p) {
      Contact& c = p.contacts[7];
      c.overlap = share * (p.radius[c.i] + p.radius[c.j]);
    });
  };
  EXPECT_EQ(overlap_of(0.99 * deepest_overlap), "");
  EXPECT_THAT(overlap_of(1.01 * deepest_overlap), HasSubstr("have run into each other"));
}

TEST(FaultOf, SeesATimeStepThatIsTooLong) {
  Model model = jammed_model();
  const double step = stiffest_step(jammed(), model);
  EXPECT_GT(step, 0.15);
  EXPECT_LT(step, 0.6);
  model.time_step *= 1.99 / step;
  EXPECT_EQ(fault_of(jammed(), model), "");
  model.time_step *= 2.01 / 1.99;
  EXPECT_THAT(fault_of(jammed(), model), HasSubstr("the time step is too long"));
}

}  // namespace
}  // namespace furnas
