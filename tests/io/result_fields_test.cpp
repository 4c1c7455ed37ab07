#include "io/result_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "io/history.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

/// The names of all numbers and words of a document, with dots; entries of lists as "list[]".
void names_in(const nlohmann::json& json, const std::string& above, std::set<std::string>& names) {
  for (const auto& [key, value] : json.items()) {
    const std::string name = above.empty() ? key : above + "." + key;
    if (value.is_object()) {
      names_in(value, name, names);
      continue;
    }
    names.insert(name);
    if (value.is_array())
      for (const auto& entry : value) names_in(entry, name + "[]", names);
  }
}

TEST(ResultFields, AreThoseOfTheFile) {
  const TemporaryFolder folder;
  Result result;
  result.measures.backbone_threshold = 2;
  result.reached = {{1e-4, 0.6, 10, 4.5, 3, 2}};
  write_result(result, {}, folder / "result.json");
  std::set<std::string> written, told;
  names_in(nlohmann::json::parse(content(folder / "result.json")), "", written);
  for (const ResultField& field : result_fields())
    EXPECT_TRUE(told.insert(std::string(field.about.name)).second);
  for (const RattlerField& field : rattler_fields())
    told.insert("rattlers[]." + std::string(field.about.name));
  for (const RestingField& field : resting_fields())
    told.insert("resting_states[]." + std::string(field.about.name));
  EXPECT_EQ(written, told);
}

template <class Fields>
void expect_told(const Fields& fields) {
  for (const auto& field : fields) {
    EXPECT_FALSE(field.about.doc.empty()) << field.about.name;
    EXPECT_FALSE(field.about.of.empty()) << field.about.name;
  }
}

TEST(ResultFields, EachIsTold) {
  expect_told(result_fields());
  expect_told(rattler_fields());
  expect_told(resting_fields());
}

TEST(HistoryFields, AreItsColumns) {
  std::vector<std::string> told;
  for (const OutputField& field : history_fields()) {
    told.emplace_back(field.name);
    EXPECT_FALSE(field.doc.empty()) << field.name;
    EXPECT_FALSE(field.of.empty()) << field.name;
  }
  EXPECT_EQ(told, history_columns());
}

}  // namespace
}  // namespace furnas
