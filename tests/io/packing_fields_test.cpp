#include "io/packing_fields.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "io/extended_xyz.h"
#include "io/packing_csv.h"
#include "io/vtp_packing.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

/// Names of the arrays in one part of a VTP file, as its XML lists them.
std::vector<std::string> arrays_in(const std::string& file, const std::string& part) {
  const std::size_t begin = file.find("<" + part + ">"), end = file.find("</" + part + ">");
  std::vector<std::string> names;
  if (begin == file.npos || end == file.npos) return names;
  const std::string text = file.substr(begin, end - begin);
  const std::regex name("Name=\"([^\"]*)\"");
  for (std::sregex_iterator it(text.begin(), text.end(), name), last; it != last; ++it)
    names.push_back((*it)[1]);
  return names;
}

std::vector<std::string> told_in(std::span<const VtpField> fields, VtpField::Place place) {
  std::vector<std::string> names;
  for (const VtpField& field : fields)
    if (field.place == place) names.emplace_back(field.about.name);
  return names;
}

void expect_same_arrays(const std::string& file, std::span<const VtpField> fields) {
  using Place = VtpField::Place;
  EXPECT_EQ(arrays_in(file, "FieldData"), told_in(fields, Place::field));
  EXPECT_EQ(arrays_in(file, "PointData"), told_in(fields, Place::point));
  EXPECT_EQ(arrays_in(file, "CellData"), told_in(fields, Place::cell));
}

TEST(PackingFields, AreTheArraysOfVtpFiles) {
  const TemporaryFolder folder;
  write_vtp(random_packing(1), folder / "a.vtp");
  expect_same_arrays(content(folder / "a.vtp"), packing_vtp_fields());
  write_contacts_vtp(random_packing(1), folder / "a.vtp");
  expect_same_arrays(content(folder / "a.vtp"), contacts_vtp_fields());
}

std::vector<std::string> split_at(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

TEST(PackingFields, AreThePropertiesOfExtendedXyz) {
  const TemporaryFolder folder;
  write_extended_xyz(random_packing(1), folder / "a.extxyz");
  const std::string text = content(folder / "a.extxyz"), key = "Properties=";
  const std::size_t begin = text.find(key) + key.size();
  const auto parts = split_at(text.substr(begin, text.find('\n', begin) - begin), ':');
  std::vector<std::string> written, told;
  for (std::size_t k = 0; k < parts.size(); k += 3) written.push_back(parts[k]);
  for (const OutputField& field : extended_xyz_fields()) told.emplace_back(field.name);
  EXPECT_EQ(written, told);
}

TEST(PackingFields, AreTheColumnsOfContactsCsv) {
  const TemporaryFolder folder;
  Packing p = random_packing(1);
  Contact contact;
  contact.i = 2, contact.j = 0, contact.sliding = true;
  contact.branch = {1, 2, 3}, contact.overlap = 0.25, contact.force = {4, 5, 6};
  p.contacts = {contact};
  write_contacts_csv(p, folder / "a.csv");
  const std::string text = content(folder / "a.csv");
  std::string names;
  for (const OutputField& field : contacts_csv_fields())
    names += (names.empty() ? "" : ",") + std::string(field.name);
  EXPECT_EQ(text, names + "\n" + std::to_string(p.id(2)) + "," + std::to_string(p.id(0)) +
                      ",1,2,3,0.25,4,5,6,0,0,0,1\n");
}

TEST(PackingFields, AreTheColumnsOfPackingCsv) {
  const TemporaryFolder folder;
  write_packing_csv(random_packing(1), folder / "a.csv");
  const std::string text = content(folder / "a.csv");
  std::vector<std::string> told;
  for (const OutputField& field : packing_csv_fields()) told.emplace_back(field.name);
  EXPECT_EQ(split_at(text.substr(0, text.find('\n')), ','), told);
}

}  // namespace
}  // namespace furnas
