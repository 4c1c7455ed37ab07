#include "io/analysis_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::HasSubstr;
using Row = std::map<std::string, std::string>;

/// Spheres of two sizes in a square of contacts, with friction: each kind occurs.
Packing square() {
  Packing p = random_packing(3, 4);
  p.species = {Species::large, Species::large, Species::small, Species::small};
  p.radius = {1, 1, 0.5, 0.5};
  p.contacts.clear();
  for (std::uint32_t k = 0; k < 4; ++k) {
    Contact c;
    c.i = k;
    c.j = (k + 1) % 4;
    c.branch = k % 2 == 0 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
    c.force = (1.0 + k) * (k % 2 == 0 ? Vec3<double>{1, 0.1, 0} : Vec3<double>{0.3, 1, 0});
    p.contacts.push_back(c);
  }
  return p;
}

AnalysisRecord record_of(const Packing& p, double friction) {
  AnalysisRecord record;
  record.analysis = analyze(p, {.friction = friction, .backbone_threshold = 2});
  record.source = "a \"folder\"";
  record.step = 77;
  return record;
}

std::string content_of(const AnalysisRecord& record, const std::string& name) {
  for (const AnalysisFile& file : analysis_files())
    if (file.name == name) return file.content(record);
  throw std::runtime_error("no file " + name);
}

std::vector<Row> rows_of(const std::string& csv) {
  const auto words = [](const std::string& line) {
    std::vector<std::string> all;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');) all.push_back(word);
    return all;
  };
  std::istringstream stream(csv);
  std::string line;
  std::getline(stream, line);
  const auto names = words(line);
  std::vector<Row> rows;
  while (std::getline(stream, line)) {
    const auto values = words(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t k = 0; k < std::min(names.size(), values.size()); ++k) row[names[k]] = values[k];
    rows.push_back(row);
  }
  return rows;
}

TEST(AnalysisFiles, DistributionsIntegrateToOneForEveryForceAndKind) {
  const AnalysisRecord record = record_of(square(), 0.3);
  std::map<std::string, double> integrals;
  for (const Row& row : rows_of(content_of(record, "forces.csv")))
    integrals[row.at("force") + " " + row.at("kind")] +=
        std::stod(row.at("density")) * (std::stod(row.at("high")) - std::stod(row.at("low")));
  for (const Row& row : rows_of(content_of(record, "mobilisation.csv")))
    integrals["mobilisation " + row.at("kind")] +=
        std::stod(row.at("density")) * (std::stod(row.at("high")) - std::stod(row.at("low")));
  EXPECT_EQ(integrals.size(), 12U) << "normal, tangential and mobilisation, of all and of three kinds";
  // Edges are written to twelve digits.
  for (const auto& [name, integral] : integrals) EXPECT_NEAR(integral, 1, 1e-9) << name;
}

TEST(AnalysisFiles, TablesSayWhatTheAnalysisFound) {
  const AnalysisRecord record = record_of(square(), 0.3);
  const auto rattlers = rows_of(content_of(record, "rattlers.csv"));
  ASSERT_EQ(rattlers.size(), 12U);
  EXPECT_EQ(rattlers[0].at("backbone"), "4") << "a ring holds at two contacts";
  EXPECT_EQ(rattlers[4].at("large"), "2");
  EXPECT_EQ(rattlers[4].at("small_share"), "1");
  const auto coordination = rows_of(content_of(record, "coordination.csv"));
  ASSERT_EQ(coordination.size(), 4U);
  EXPECT_EQ(coordination[1].at("particles"), "all");
  EXPECT_EQ(coordination[1].at("species"), "small");
  EXPECT_EQ(coordination[1].at("contacts_with_large"), "1");
  EXPECT_EQ(coordination[1].at("contacts_with_small"), "1");
  const auto fabric = rows_of(content_of(record, "fabric.csv"));
  ASSERT_EQ(fabric.size(), 8U);
  EXPECT_EQ(fabric[0].at("kind"), "all");
  EXPECT_EQ(fabric[0].at("xx"), "0.5");
  EXPECT_EQ(fabric[0].at("zz"), "0");
  EXPECT_EQ(fabric[1].at("kind"), "large-large");
  EXPECT_EQ(fabric[1].at("anisotropy"), "1");
  const auto pairs = rows_of(content_of(record, "pair_correlation.csv"));
  std::map<std::string, double> last;
  for (const Row& row : pairs) last[row.at("kind")] = std::stod(row.at("neighbours"));
  ASSERT_EQ(last.size(), 4U);
  for (const PairCorrelation& p : record.analysis.pairs)
    EXPECT_DOUBLE_EQ(last.at(std::string(name_of(p.kind))), p.neighbours.back());
}

TEST(AnalysisFiles, TheSummaryIsJson) {
  AnalysisRecord record = record_of(square(), 0.3);
  const auto json = nlohmann::json::parse(content_of(record, "analysis.json"));
  EXPECT_EQ(json["source"], "a \"folder\"");
  EXPECT_EQ(json["step"], 77);
  EXPECT_TRUE(json["phi_J"].is_null());
  EXPECT_DOUBLE_EQ(
      json["phi_L"].get<double>() + json["phi_S"].get<double>() * (1 - json["phi_L"].get<double>()),
      json["phi"].get<double>());
  EXPECT_EQ(json["contacts_are"], "of the source");
  EXPECT_EQ(json["network"]["coordination"]["Z"], 2);
  EXPECT_EQ(json["network"]["backbone"].size(), 4U);
  EXPECT_DOUBLE_EQ(json["network"]["backbone"][0]["mean_normal_force"], 2.5);
  // Forces across the normal are 0.1 and 0.3 of those along it; friction is 0.3.
  EXPECT_DOUBLE_EQ(json["network"]["backbone"][0]["sliding_share"], 0.5);
  EXPECT_EQ(json["pair_correlation"].size(), 4U);
  record.phi_J = 0.6;
  record.contacts_are_overlaps = true;
  const auto other = nlohmann::json::parse(content_of(record, "analysis.json"));
  EXPECT_EQ(other["phi_J"], 0.6);
  EXPECT_EQ(other["contacts_are"], "overlaps");
}

TEST(AnalysisFiles, WithoutFrictionOrContactsThereIsLessToWrite) {
  EXPECT_EQ(content_of(record_of(square(), 0), "mobilisation.csv"), "");
  EXPECT_FALSE(
      nlohmann::json::parse(content_of(record_of(square(), 0), "analysis.json"))["network"]["backbone"][0]
          .contains("sliding_share"));
  Packing p = square();
  p.contacts.clear();
  const AnalysisRecord gas = record_of(p, 0.3);
  for (const char* name :
       {"coordination.csv", "rattlers.csv", "forces.csv", "mobilisation.csv", "fabric.csv"})
    EXPECT_EQ(content_of(gas, name), "") << name;
  const auto json = nlohmann::json::parse(content_of(gas, "analysis.json"));
  EXPECT_FALSE(json.contains("network"));
  EXPECT_TRUE(json["contacts_are"].is_null());
  EXPECT_NE(content_of(gas, "pair_correlation.csv"), "");
}

TEST(AnalysisFiles, PhiJIsThatOfTheResult) {
  const TemporaryFolder folder;
  const auto root = (folder / "x").parent_path();
  EXPECT_FALSE(read_phi_J(root)) << "no result";
  write_file(folder / "result.json", R"({"phi_J": null})");
  EXPECT_FALSE(read_phi_J(root));
  write_file(folder / "result.json", R"({"phi_J": 0.625})");
  EXPECT_EQ(read_phi_J(root), 0.625);
  for (const char* damaged : {"{", "[]", "{}", R"({"phi_J": "high"})"}) {
    write_file(folder / "result.json", damaged);
    EXPECT_THAT(input_error([&] { read_phi_J(root); }), HasSubstr("result.json: phi_J"));
  }
}

}  // namespace
}  // namespace furnas
