#include "io/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <sstream>

#include "engine/base/require.h"
#include "io/particle_rows.h"
#include "io/section_file.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

constexpr SectionFormat checkpoint_format{checkpoint_magic, 2};

static_assert(sizeof(Cell) == 12 * sizeof(double) && sizeof(Fraction) == 3 * sizeof(std::uint64_t) &&
                  sizeof(Vec3<double>) == 3 * sizeof(double) && sizeof(Ledger) == 17 * sizeof(double),
              "stored as bytes: there must be no padding");

/// How a field is stored: a truth value as a byte, all else as it is.
template <class T>
using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;

/// Writes the sections that exchange() lists.
class Saver {
 public:
  explicit Saver(const std::filesystem::path& path) : writer_(path, checkpoint_format) {}

  template <class T>
  void one(std::string_view name, const T& value) {
    writer_.array<T>(name, 1, [&](std::size_t) { return value; });
  }
  template <class List>
  void list(std::string_view name, const List& values) {
    writer_.array<typename List::value_type>(name, values.size(), [&](std::size_t k) { return values[k]; });
  }
  void matrix(std::string_view name, const Eigen::Matrix3d& value) {
    writer_.array<double>(name, 9, [&](std::size_t k) { return value.data()[k]; });
  }
  template <class Contacts, class T>
  void contact_field(std::string_view name, const Contacts& contacts, T Contact::*field) {
    writer_.array<Stored<T>>(name, contacts.size(),
                             [&](std::size_t k) -> Stored<T> { return contacts[k].*field; });
  }
  void texts(const std::map<std::string, std::string>& values) {
    one("extras", std::uint64_t{values.size()});
    for (const auto& [key, value] : values) {
      list("key of an extra", key);
      list("value of an extra", value);
    }
  }
  void finish() { writer_.commit(); }

 private:
  SectionWriter writer_;
};

/// Reads the sections that exchange() lists. Lists grow as their elements are read; no number in the file
/// sets their size in advance.
class Loader {
 public:
  explicit Loader(const std::filesystem::path& path) : reader_(path, checkpoint_format) {}

  template <class T>
  void one(std::string_view name, T& value) {
    std::vector<T> values;
    list(name, values);
    if (values.size() != 1) reader_.fail("must have one element");
    value = values[0];
  }
  template <class List>
  void list(std::string_view name, List& values) {
    values.clear();
    reader_.array<typename List::value_type>(name, [&](const auto& element) { values.push_back(element); });
  }
  void matrix(std::string_view name, Eigen::Matrix3d& value) {
    std::vector<double> values;
    list(name, values);
    if (values.size() != 9) reader_.fail("must have nine elements");
    std::copy(values.begin(), values.end(), value.data());
  }
  /// The first field, the particle i, creates the contacts; each other field must have as many elements.
  template <class T>
  void contact_field(std::string_view name, std::vector<Contact>& contacts, T Contact::*field) {
    constexpr bool truth = std::is_same_v<T, bool>;
    std::size_t k = 0;
    reader_.array<Stored<T>>(name, [&](const Stored<T>& value) {
      if constexpr (std::is_same_v<T, std::uint32_t>) {
        if (field == &Contact::i) contacts.emplace_back();
      }
      if (k == contacts.size()) reader_.fail("has more elements than there are contacts");
      if (truth && value != Stored<T>{} && value != Stored<T>{1})
        reader_.fail("has a truth value other than 0 and 1");
      contacts[k++].*field = static_cast<T>(value);
    });
    if (k != contacts.size()) reader_.fail("has fewer elements than there are contacts");
  }
  void texts(std::map<std::string, std::string>& values) {
    std::uint64_t count = 0;
    one("extras", count);
    for (std::uint64_t k = 0; k < count; ++k) {
      std::string key, value;
      list("key of an extra", key);
      list("value of an extra", value);
      if (!values.emplace(std::move(key), std::move(value)).second) reader_.fail("its key occurs twice");
    }
  }
  void finish() { reader_.finish(); }

 private:
  SectionReader reader_;
};

/// The first sections: they show what a file is about before the rest is read.
template <class Archive, class AnyCheckpoint>
void exchange_head(Archive& archive, AnyCheckpoint& checkpoint) {
  archive.list("case", checkpoint.case_text);
  archive.one("step", checkpoint.packing.step);
}

template <class Archive, class AnyPacking>
void exchange_order(Archive& archive, AnyPacking& packing) {
  archive.list("order", packing.order);
}
template <class Archive>
void exchange_order(Archive& archive, const Replica& replica) {
  archive.list("order", replica.memory_order());
}

/// The sections of a checkpoint in order, for writing and for reading.
template <class Archive, class AnyCheckpoint>
void exchange(Archive& archive, AnyCheckpoint& checkpoint) {
  auto& p = checkpoint.packing;
  exchange_head(archive, checkpoint);
  archive.one("time", p.time);
  archive.one("cell", p.cell);
  archive.list("species", p.species);
  archive.list("radius", p.radius);
  archive.list("mass", p.mass);
  archive.list("fraction", p.fraction);
  archive.list("image", p.image);
  archive.list("velocity", p.velocity);
  archive.list("spin", p.spin);
  archive.list("force", p.force);
  archive.list("torque", p.torque);
  archive.contact_field("contact i", p.contacts, &Contact::i);
  archive.contact_field("contact j", p.contacts, &Contact::j);
  archive.contact_field("contact image", p.contacts, &Contact::image);
  archive.contact_field("contact branch", p.contacts, &Contact::branch);
  archive.contact_field("contact overlap", p.contacts, &Contact::overlap);
  archive.contact_field("contact force", p.contacts, &Contact::force);
  archive.contact_field("contact history", p.contacts, &Contact::history);
  archive.contact_field("contact sliding", p.contacts, &Contact::sliding);
  archive.matrix("stress of contacts", p.stress.contacts);
  archive.matrix("stress of motion", p.stress.motion);
  archive.one("ledger", p.ledger);
  exchange_order(archive, p);
  archive.texts(checkpoint.extras);
  archive.finish();
}

// Labels are stored among the extras, so that a checkpoint without labels needs no section for them.
constexpr const char* id_key = "labels: id";
constexpr const char* type_key = "labels: type";
constexpr const char* names_key = "labels: names";
constexpr const char* origin_key = "labels: origin";

template <class T>
std::string bytes_of(const std::vector<T>& list) {
  return {reinterpret_cast<const char*>(list.data()), sizeof(T) * list.size()};
}

template <class T>
std::vector<T> list_in(const std::string& bytes) {
  std::vector<T> list(bytes.size() / sizeof(T));
  if (!list.empty()) std::memcpy(list.data(), bytes.data(), sizeof(T) * list.size());
  return list;
}

std::map<std::string, std::string> to_extras(const Labels& labels) {
  std::map<std::string, std::string> extras;
  if (!labels.id.empty()) extras[id_key] = bytes_of(labels.id);
  if (!labels.type.empty()) extras[type_key] = bytes_of(labels.type);
  if (!labels.names.empty()) extras[names_key] = fmt::format("{}", fmt::join(labels.names, "\n"));
  const Vec3<double>& corner = labels.origin;
  if (corner != Vec3<double>{}) extras[origin_key] = bytes_of(std::vector{corner.x, corner.y, corner.z});
  return extras;
}

/// Moves the labels out of the extras.
Labels take_labels(std::map<std::string, std::string>& extras) {
  const auto take = [&](const char* key) {
    const auto node = extras.extract(key);
    return node.empty() ? std::string() : node.mapped();
  };
  Labels labels;
  labels.id = list_in<std::int64_t>(take(id_key));
  labels.type = list_in<std::int32_t>(take(type_key));
  if (std::istringstream names(take(names_key)); names)
    for (std::string name; std::getline(names, name);) labels.names.push_back(name);
  if (const auto corner = list_in<double>(take(origin_key)); corner.size() == 3)
    labels.origin = {corner[0], corner[1], corner[2]};
  return labels;
}

/// The hashes show that every byte is as written; here the sections are checked against each other.
void check(const Packing& p, const std::filesystem::path& path) {
  const auto fail = [&](const char* section, const char* what) {
    throw InputError(path.string() + ": section '" + section + "': " + what);
  };
  const std::size_t n = p.size();
  const auto same = [&](const char* section, std::size_t count) {
    if (count != n) fail(section, "has a different number of particles than 'radius'");
  };
  same("species", p.species.size());
  same("mass", p.mass.size());
  same("fraction", p.fraction.size());
  same("image", p.image.size());
  same("velocity", p.velocity.size());
  same("spin", p.spin.size());
  same("force", p.force.size());
  same("torque", p.torque.size());
  for (const Species s : p.species)
    if (s != Species::large && s != Species::small)
      fail("species", "has a value beyond 0 (large) and 1 (small)");
  if (!p.labels.id.empty()) same("labels: id", p.labels.id.size());
  if (!p.labels.type.empty()) same("labels: type", p.labels.type.size());
  if (!p.order.empty()) {
    same("order", p.order.size());
    std::vector<bool> seen(n);
    for (const std::uint32_t k : p.order) {
      if (k >= n || seen[k]) fail("order", "does not have every particle once");
      seen[k] = true;
    }
  }
  check_packing(p, path);
}

/// Writes a view of a checkpoint with the labels of its packing among the extras. The arrays are not copied.
template <class View>
void write_labelled(View view, const std::filesystem::path& path) {
  Saver saver(path);
  view.extras.merge(to_extras(view.packing.labels));
  exchange(saver, view);
}

}  // namespace

bool is_checkpoint(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  std::string head(checkpoint_magic.size(), '\0');
  open_file(path).read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == checkpoint_magic;
}

void write_checkpoint(const CheckpointView& checkpoint, const std::filesystem::path& path) {
  write_labelled(checkpoint, path);
}

void write_checkpoint(const ReplicaCheckpoint& checkpoint, const std::filesystem::path& path) {
  write_labelled(checkpoint, path);
}

std::int64_t checkpoint_step(const std::filesystem::path& path) {
  Checkpoint head;
  Loader loader(path);
  exchange_head(loader, head);
  return head.packing.step;
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  Checkpoint checkpoint;
  Loader loader(path);
  exchange(loader, checkpoint);
  checkpoint.packing.labels = take_labels(checkpoint.extras);
  check(checkpoint.packing, path);
  return checkpoint;
}

}  // namespace furnas
