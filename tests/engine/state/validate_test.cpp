#include "engine/state/validate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "engine/certificate/certify.h"
#include "engine/protocol/protocol.h"
#include "engine/simulation.h"
#include "engine/start/mixture.h"

namespace furnas {
namespace {

using testing::HasSubstr;

/// What is wrong with ten spheres after a change.
template <class Change>
std::string flaw_after(Change&& change) {
  Packing p = dilute_start({.large = 10});
  change(p);
  try {
    validate(p);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Validate, TakesAStart) {
  EXPECT_EQ(flaw_after([](Packing&) {}), "");
}

TEST(Validate, EveryArrayHasOneNumberForEachParticle) {
  EXPECT_EQ(flaw_after([](Packing& p) { p.mass.pop_back(); }), "the packing has 10 radii and 9 masses");
  EXPECT_THAT(flaw_after([](Packing& p) { p.species.clear(); }), HasSubstr("0 species"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.fraction.pop_back(); }), HasSubstr("9 positions"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.image.emplace_back(); }), HasSubstr("11 images"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.velocity.clear(); }), HasSubstr("0 velocities"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.spin.clear(); }), HasSubstr("0 spins"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.force.clear(); }), HasSubstr("0 forces"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.torque.clear(); }), HasSubstr("0 torques"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.labels.id = {1, 2}; }), HasSubstr("2 ids"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.labels.type = {1}; }), HasSubstr("1 types"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.order = {0, 1, 2}; }), HasSubstr("3 places"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.radius.clear(); }), HasSubstr("no particles"));
}

TEST(Validate, AnOrderNamesEveryParticleOnce) {
  EXPECT_THAT(flaw_after([](Packing& p) { p.order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 8}; }),
              HasSubstr("names particle 9 twice"));
  EXPECT_THAT(flaw_after([](Packing& p) { p.order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 10}; }),
              HasSubstr("a particle that is not there"));
}

TEST(Validate, ContactsAreOfParticlesThatAreThere) {
  const auto add = [](Packing& p) {
    Contact c;
    c.i = 3, c.j = 10;
    p.contacts.push_back(c);
  };
  EXPECT_EQ(flaw_after(add), "a contact is of particle 11, and there are 10 particles");
}

// Beyond it the numbers of the images no longer fit into integers.
TEST(Validate, ATiltIsAtMostAMillionEdges) {
  for (double Triangle::*tilt : {&Triangle::xy, &Triangle::xz, &Triangle::yz}) {
    EXPECT_EQ(flaw_after([&](Packing& p) { p.cell.edges.*tilt = 0.99e6 * p.cell.edges.xx; }), "");
    EXPECT_THAT(flaw_after([&](Packing& p) { p.cell.edges.*tilt = -1.01e6 * p.cell.edges.xx; }),
                HasSubstr("tilt"));
  }
}

TEST(Validate, GuardsSimulationAndCertificate) {
  Packing p = dilute_start({.large = 10});
  p.velocity.clear();
  EXPECT_THROW(make_simulation(model_of({}, p), p), InputError);
  EXPECT_THROW(certify(p, {}), InputError);
}

// Spheres would touch a thousand images of themselves: no list can hold them.
TEST(Validate, ASimulationRefusesACellThatIsTooThin) {
  Packing p = dilute_start({.large = 10});
  p.cell.edges.zz = 1e-3;
  EXPECT_THROW(make_simulation(model_of({}, p), p), InputError);
}

}  // namespace
}  // namespace furnas
