#include "engine/state/fingerprint.h"

#include <algorithm>
#include <array>
#include <compare>
#include <numeric>
#include <span>

#include "engine/base/hasher.h"

namespace furnas {
namespace {

static_assert(sizeof(Vec3<double>) == 3 * sizeof(double) && sizeof(Triangle) == 6 * sizeof(double) &&
                  sizeof(Fraction) == 3 * sizeof(std::uint64_t),
              "hashed as bytes: there must be no padding");

/// The key that identifies a contact; it does not depend on which particle is named first.
struct Key {
  std::uint32_t i{}, j{};
  std::array<std::int8_t, 3> image{};
  friend auto operator<=>(const Key&, const Key&) = default;  // NOLINT(modernize-use-nullptr): not ours
};

std::array<std::int8_t, 3> opposite(const std::array<std::int8_t, 3>& image) {
  return {static_cast<std::int8_t>(-image[0]), static_cast<std::int8_t>(-image[1]),
          static_cast<std::int8_t>(-image[2])};
}

/// Whether the two particles of a contact must be exchanged for its key. A contact of a particle with its own
/// image also has two descriptions; the key uses the one whose image comes first.
bool reversed(const Contact& c) { return c.i > c.j || (c.i == c.j && opposite(c.image) < c.image); }

Key key(const Contact& c) { return reversed(c) ? Key{c.j, c.i, opposite(c.image)} : Key{c.i, c.j, c.image}; }

void add_contact(Hasher& hasher, const Contact& c) {
  const Key k = key(c);
  hasher.add(k.i);
  hasher.add(k.j);
  hasher.add(k.image);
  const Vec3<double> history = reversed(c) ? -c.history : c.history;
  hasher.add(history + Vec3<double>{});  // turns -0 into 0: without friction the sign has no meaning
}

void add_contacts(Hasher& hasher, const std::vector<Contact>& contacts) {
  hasher.add(std::uint64_t{contacts.size()});
  const auto before = [](const Contact& a, const Contact& b) { return key(a) < key(b); };
  if (std::is_sorted(contacts.begin(), contacts.end(), before)) {
    for (const Contact& c : contacts) add_contact(hasher, c);
    return;
  }
  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return before(contacts[a], contacts[b]); });
  for (std::size_t k : order) add_contact(hasher, contacts[k]);
}

}  // namespace

std::uint64_t state_hash(const Packing& packing) {
  Hasher hasher;
  hasher.add(packing.step);
  hasher.add(packing.cell.edges);
  hasher.add(packing.cell.rate);
  hasher.add(std::uint64_t{packing.size()});
  hasher.add(std::span<const Fraction>(packing.fraction));
  hasher.add(std::span<const Vec3<double>>(packing.velocity));
  hasher.add(std::span<const Vec3<double>>(packing.spin));
  add_contacts(hasher, packing.contacts);
  return hasher.value();
}

std::string hex(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t digit = 16; digit-- > 0; hash >>= 4) text[digit] = "0123456789abcdef"[hash & 15];
  return text;
}

}  // namespace furnas
