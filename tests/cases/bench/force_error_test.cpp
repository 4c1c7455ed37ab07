#include "cases/program/bench/force_error.h"

#include <gtest/gtest.h>

#include "cases/program/bench/packings.h"
#include "engine/simulation.h"
#include "io/lammps_data.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

Packing moving_packing() { return read_lammps_data(test_data("a8.data")); }

Packing forces_of(const Model& model, const Packing& packing) {
  return make_simulation(model, packing)->packing();
}

TEST(ForceErrorTest, IsRoundingForEveryLawInDoublePrecision) {
  const Packing packing = moving_packing();
  for (const char* law : {"hooke_synchronized", "hooke_history"})
    for (const double friction : {0.0, 0.3}) {
      const Model model = model_for({law, friction, "double"}, packing);
      const ForceError error = force_error(model, packing);
      EXPECT_EQ(error.contacts, forces_of(model, packing).contacts.size());
      EXPECT_GT(error.contacts, packing.size() / 4);
      EXPECT_EQ(error.missed + error.spurious, 0U) << law << friction;
      EXPECT_GT(error.median, 0) << law << friction;
      EXPECT_LT(error.median, 1e-12) << law << friction;
      EXPECT_LT(error.largest, 1e-11) << law << friction;
    }
}

TEST(ForceErrorTest, IsThatOfSinglePrecisionWhenMixed) {
  const Packing packing = moving_packing();
  const ForceError error = force_error(model_for({"hooke_synchronized", 0.3, "mixed"}, packing), packing);
  EXPECT_GT(error.median, 1e-10);
  EXPECT_LT(error.median, 1e-6);
  EXPECT_LT(error.mistaken(), 1e-3);
}

TEST(ForceErrorTest, SeesWhatIsWrong) {
  const Packing packing = moving_packing();
  const Model model = model_for({"hooke_synchronized", 0.3, "double"}, packing);
  std::vector<Contact> contacts = forces_of(model, packing).contacts;
  std::swap(contacts[3].i, contacts[3].j);  // which is named first means nothing
  contacts[3].branch = -contacts[3].branch;
  contacts[3].force = -contacts[3].force;
  EXPECT_EQ(force_error(model.law, packing, contacts).missed, 0U);

  std::vector<Contact> wrong = contacts;
  for (Contact& c : wrong) c.force *= 1 + 1e-6;
  EXPECT_NEAR(force_error(model.law, packing, wrong).median, 1e-6, 1e-9);
  wrong.back().force = {};
  EXPECT_GT(force_error(model.law, packing, wrong).largest, 1e-3);

  wrong = contacts;
  wrong.pop_back();
  EXPECT_EQ(force_error(model.law, packing, wrong).missed, 1U);
  wrong.push_back(contacts.front());
  const ForceError both = force_error(model.law, packing, wrong);
  EXPECT_EQ(both.missed, 1U);
  EXPECT_EQ(both.spurious, 1U);
  EXPECT_EQ(both.mistaken(), 2 / static_cast<double>(contacts.size()));
}

}  // namespace
}  // namespace furnas
