#include "engine/monitor/audit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/trials/crystal.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using testing::HasSubstr;

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
