#include "io/history.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "io/csv.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// Measures each of whose numbers is another one.
Measures example(std::int64_t step) {
  Measures m;
  m.step = step;
  double x = 0.1;
  const auto number = [&] { return x += 1.0 / 3; };
  m.time = number(), m.phi = number(), m.pressure = number();
  for (double& s : m.stress) s = number();
  m.kinetic_energy = number(), m.backbone_kinetic_energy = number(), m.force_imbalance = number();
  m.contacts = 17, m.coordination = number();
  m.rattlers[0].backbone = 18, m.rattlers[1].backbone = 19, m.rattlers[2].backbone = 20;
  m.backbone_threshold = 3;
  m.sliding_share = number(), m.largest_overlap = number();
  m.cell.edges = {2, 3, 4, 0.1, 0.2, 0.3};
  m.particles = 10;
  m.energy = {number(), number(), number()};
  m.ledger = {number(), number(), {number(), number(), number(), number()}, number(), {}};
  return m;
}

TEST(History, HasAColumnForEachNumber) {
  const TemporaryFolder folder;
  const Measures m = example(1000);
  History(folder / "history.csv").add(m);
  const auto lines = split(content(folder / "history.csv"), '\n');
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0] + "\n", csv_row(history_columns()));
  const auto columns = split(lines[0], ',');
  const auto values = split(lines[1], ',');
  ASSERT_EQ(values.size(), columns.size());
  const auto value = [&](const char* column) {
    const auto at = std::find(columns.begin(), columns.end(), column);
    EXPECT_NE(at, columns.end()) << column;
    return at == columns.end() ? 0.0 : std::stod(values[static_cast<std::size_t>(at - columns.begin())]);
  };
  EXPECT_EQ(value("Step"), 1000);
  EXPECT_EQ(value("Time"), m.time);  // every bit
  EXPECT_EQ(value("Phi"), m.phi);
  EXPECT_EQ(value("Press"), m.pressure);
  const char* const stresses[] = {"Pxx", "Pyy", "Pzz", "Pxy", "Pxz", "Pyz"};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(value(stresses[k]), m.stress[k]);
  EXPECT_EQ(value("KinEng"), m.kinetic_energy);
  EXPECT_EQ(value("KinEngBackbone"), m.backbone_kinetic_energy);
  EXPECT_EQ(value("ForceImbalance"), m.force_imbalance);
  EXPECT_EQ(value("Contacts"), 17);
  EXPECT_EQ(value("Z"), m.coordination);
  EXPECT_EQ(value("Backbone"), 19);  // of the threshold 3
  EXPECT_EQ(value("SlidingShare"), m.sliding_share);
  EXPECT_EQ(value("MaxOverlap"), m.largest_overlap);
  EXPECT_EQ(value("Volume"), 24);
  EXPECT_EQ(value("Lx"), 2);
  EXPECT_EQ(value("Ly"), 3);
  EXPECT_EQ(value("Lz"), 4);
  EXPECT_EQ(value("Xy"), 0.3);
  EXPECT_EQ(value("Xz"), 0.2);
  EXPECT_EQ(value("Yz"), 0.1);
  EXPECT_EQ(value("NormalEnergy"), m.energy.normal / 10);
  EXPECT_EQ(value("TangentialEnergy"), m.energy.tangential / 10);
  EXPECT_EQ(value("CellWork"), m.ledger.cell_work / 10);
  EXPECT_EQ(value("NormalDamping"), m.ledger.losses.normal_damping / 10);
  EXPECT_EQ(value("TangentialDamping"), m.ledger.losses.tangential_damping / 10);
  EXPECT_EQ(value("Sliding"), m.ledger.losses.sliding / 10);
  EXPECT_EQ(value("Opening"), m.ledger.losses.opening / 10);
  EXPECT_EQ(value("Quenched"), m.ledger.quenched / 10);
  const Energy& e = m.energy;
  const Ledger& l = m.ledger;
  EXPECT_NEAR(value("EnergyGap"),
              (e.kinetic + e.normal + e.tangential - l.initial - l.cell_work + l.losses.normal_damping +
               l.losses.tangential_damping + l.losses.sliding + l.losses.opening + l.quenched) /
                  10,
              1e-15);
}

/// The steps of the rows.
std::vector<std::string> steps(const std::filesystem::path& path) {
  std::vector<std::string> found;
  for (const std::string& line : split(content(path), '\n')) found.push_back(line.substr(0, line.find(',')));
  return found;
}

using Steps = std::vector<std::string>;

TEST(History, ANewFileHasItsHeaderAlone) {
  const TemporaryFolder folder;
  const History history(folder / "history.csv");
  EXPECT_EQ(content(folder / "history.csv"), csv_row(history_columns()));
  EXPECT_EQ(folder.files(), 1u);
}

TEST(History, GoesOnWhereItWasMarked) {
  const TemporaryFolder folder;
  const auto path = folder / "history.csv";
  FileMark first, second;
  {
    History history(path);
    history.add(example(500));
    first = history.mark();
    for (std::int64_t step : {1000, 1500}) history.add(example(step));
    second = history.mark();
    history.add(example(2000));
  }
  {
    History history(path, second);
    EXPECT_EQ(steps(path), (Steps{"Step", "500", "1000", "1500"}));
    history.add(example(2000));
    EXPECT_EQ(steps(path), (Steps{"Step", "500", "1000", "1500", "2000"}));
  }
  History history(path, first);
  EXPECT_EQ(steps(path), (Steps{"Step", "500"}));
  EXPECT_EQ(history.mark(), first);
}

TEST(History, SaysWhatItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THROW(History(folder / "none/history.csv"), OutputError);
}

}  // namespace
}  // namespace furnas
