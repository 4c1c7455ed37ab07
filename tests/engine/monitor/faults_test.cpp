#include "engine/monitor/faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>

#include "engine/monitor/audit.h"
#include "engine/monitor/stability.h"
#include "tests/engine/phases/crystal.h"
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

/// Two equal spheres that stick: normal mode k/m_eff, tangential mode with rotation 3.5 k_t/m_eff, so the
/// bound is exact.
TEST(StiffestStep, IsExactForAStickingPair) {
  Packing p = packing_of(cube(10), {{.position = {1, 1, 1}}, {.position = {1.9, 1, 1}}});
  Model model = model_of<HookeSynchronized>({.friction = 0.3});
  p = after(model, p, 0);
  const double m_eff = 0.5 * mass_of(0.5);
  EXPECT_NEAR(stiffest_step(p, model), model.time_step * std::sqrt(3.5 / m_eff), 1e-14);
  Model smooth = model_of<Frictionless<false>>({});
  EXPECT_NEAR(stiffest_step(p, smooth), smooth.time_step * std::sqrt(1 / m_eff), 1e-14);
}

/// Frictionless springs of the jammed packing: the largest eigenvalue of M^-1 K, with K built by hand.
TEST(StiffestStep, BoundsTheFrequenciesOfAPacking) {
  const Packing& p = jammed();
  const auto n = static_cast<Eigen::Index>(3 * p.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (const Contact& c : p.contacts) {
    const Eigen::Vector3d normal = Eigen::Vector3d(c.branch.x, c.branch.y, c.branch.z).normalized();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(n);
    u.segment<3>(3 * c.i) += normal / std::sqrt(p.mass[c.i]);
    u.segment<3>(3 * c.j) -= normal / std::sqrt(p.mass[c.j]);
    k += u * u.transpose();
  }
  Model model = jammed_model();
  model.law = Frictionless<false>{};
  const double exact =
      model.time_step *
      std::sqrt(
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues()(n - 1));
  const double bound = stiffest_step(p, model);
  EXPECT_GE(bound, exact);
  EXPECT_LT(bound, 2 * exact);  // and is not idle
}

/// A step that passed over a contact (its particles have moved, but not it) must not look sound from outside.
TEST(AuditContacts, FindsWhatTheStepHasPassedOver) {
  Packing p = jammed();
  ASSERT_FALSE(p.order.empty());  // so that the contacts are those of the last step, not found anew
  p.contacts.erase(p.contacts.begin() + 7);
  const Packing out = make_simulation(jammed_model(), p)->packing();
  EXPECT_EQ(out.contacts.size(), p.contacts.size());
  EXPECT_THAT(audit_contacts(out, out.size(), 1), HasSubstr("has missed"));
}

TEST(AuditContacts, AgreesWithTheEngine) {
  EXPECT_EQ(audit_contacts(jammed(), jammed().size(), 1), "");
  Packing p = squeezed(0.1);
  p.order.clear();  // so that contacts are found anew
  EXPECT_EQ(audit_contacts(after(jammed_model(), p, 0), 1000, 7), "");
}

/// A cell so small that spheres touch several images of a partner and of themselves.
TEST(AuditContacts, KnowsEveryImage) {
  const Packing p =
      after(model_of<HookeSynchronized>({.friction = 0.3}),
            packing_of({1.9, 1.7, 1.6, 0.4, -0.6, 0.7},
                       {{.position = {0.1, 0.2, 0.3}, .radius = 0.9}, {.position = {1.0, 0.9, 0.8}}}),
            0);
  EXPECT_GT(p.contacts.size(), 4U);
  EXPECT_EQ(audit_contacts(p, 2, 3), "");
}

TEST(AuditContacts, FindsAContactThatWasMissed) {
  for (std::size_t k : {std::size_t{0}, std::size_t{100}, jammed().contacts.size() - 1}) {
    Packing p = jammed();
    const Contact c = p.contacts[k];
    p.contacts.erase(p.contacts.begin() + static_cast<std::ptrdiff_t>(k));
    const std::string sentence = audit_contacts(p, p.size(), 1);
    EXPECT_THAT(sentence, HasSubstr("has missed the contact of particles"));
    EXPECT_THAT(sentence, HasSubstr(std::to_string(c.i + 1)));
    EXPECT_THAT(sentence, HasSubstr(std::to_string(c.j + 1)));
  }
}

TEST(AuditContacts, FindsAContactThatIsNone) {
  Packing p = jammed();
  Contact c = p.contacts[5];
  c.j = c.j == 0 ? 1 : c.j - 1;
  p.contacts.push_back(c);
  EXPECT_THAT(audit_contacts(p, p.size(), 1), HasSubstr("has a contact that is none"));
}

}  // namespace
}  // namespace furnas
