#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "tests/fuzz/targets.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

const fs::path corpus = fs::path(FURNAS_SOURCE_DIR) / "tests/fuzz/corpus";

/// Every stored input, among them all that have ever broken a parser.
std::vector<std::string> inputs_of(const FuzzTarget& target) {
  std::vector<std::string> inputs;
  for (const auto& entry : fs::directory_iterator(corpus / target.name))
    inputs.push_back(content(entry.path()));
  return inputs;
}

/// One of the changes that a fuzzer makes: a byte, a cut, a piece out, a piece twice, a huge number.
std::string changed(std::string text, std::mt19937_64& random) {
  if (text.empty()) return text;
  const std::size_t at = random() % text.size();
  const std::size_t length = std::min<std::size_t>(random() % 32, text.size() - at);
  switch (random() % 6) {
    case 0:
      text[at] = static_cast<char>(random());
      break;
    case 1:
      text.resize(at);
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(at, text.substr(at, length));
      break;
    case 4:
      text.replace(at, length, "99999999999999999999");
      break;
    default:
      text[at] = static_cast<char>(text[at] ^ (1 << random() % 8));
  }
  return text;
}

class ReliableCorpus : public testing::TestWithParam<FuzzTarget> {};

TEST_P(ReliableCorpus, BreaksNoParser) {
  const auto inputs = inputs_of(GetParam());
  ASSERT_GE(inputs.size(), 3u);
  for (const std::string& input : inputs) EXPECT_NO_THROW(GetParam().parse(input));
}

TEST_P(ReliableCorpus, NorDoItsNeighbours) {
  std::mt19937_64 random(1);
  const auto inputs = inputs_of(GetParam());
  std::size_t tried = 0;
  for (const std::string& input : inputs)
    for (int n = 0; n < 100; ++n, ++tried) {
      std::string text = changed(input, random);
      for (auto more = random() % 4; more > 0; --more) text = changed(text, random);
      EXPECT_NO_THROW(GetParam().parse(text)) << testing::PrintToString(text);
    }
  std::cout << "inputs tried: " << tried + inputs.size() << '\n';
}

INSTANTIATE_TEST_SUITE_P(Reliable, ReliableCorpus,
                         testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto& test) {
                           std::string name(test.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace furnas
