#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

#include "io/case_file.h"
#include "io/case_schema.h"
#include "io/case_words.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

using testing::HasSubstr;

/// Values that are wrong for a key, whatever else the case says; made from the key's own line in the schema.
std::vector<std::string> wrong_values(const Key& key) {
  Case any;
  const Field field = key.field(any);
  const bool text = std::holds_alternative<std::string*>(field);
  const bool truth = std::holds_alternative<bool*>(field);
  const bool whole = std::holds_alternative<std::int64_t*>(field) || std::holds_alternative<int*>(field) ||
                     std::holds_alternative<std::optional<int>*>(field);
  std::vector<std::string> wrong{"{}", "{a = 1}", "1979-05-27", "[[1]]", "[\"a\"]", "[]"};
  if (text || truth) {
    for (const char* value : {"1", "0.5", "nan"}) wrong.emplace_back(value);
    wrong.emplace_back(text ? "true" : "\"true\"");
    if (std::holds_alternative<Choices>(key.allowed))
      for (const char* value : {"\"\"", "\"nonsense\"", "\"a\\u0000b\""}) wrong.emplace_back(value);
    return wrong;
  }
  for (const char* value : {"nan", "inf", "-inf", "1e400", "-1e400", "\"abc\"", "\"1\"", "true",
                            "99999999999999999999999", "-1e300", "1e300"})
    wrong.emplace_back(value);
  if (whole)
    for (const char* value : {"0.5", "1e-3", "1e300", "9223372036854775808"}) wrong.emplace_back(value);
  const Range& range = std::get<Range>(key.allowed);
  const auto number = [&](double value) {
    return whole ? fmt::format("{}", static_cast<std::int64_t>(value)) : fmt::format("{:#}", value);
  };
  const double step = whole ? 1 : 1e-9 * std::max(1.0, std::abs(range.most));
  wrong.push_back(number(range.above_least ? range.least : range.least - step));
  if (range.most < 1e18) wrong.push_back(number(range.below_most ? range.most : range.most + step));
  return wrong;
}

/// What `run` says about a case of this text: one line, the code of a bad case, and nothing created.
std::string refusal_of(const Runs& runs, const std::string& text) {
  write_file(runs.path("bad.toml"), text);
  const std::size_t files = runs.files();
  const Answer answer = furnas({"run", runs.path("bad.toml"), "--out", runs.path("run")});
  EXPECT_EQ(answer.code, ExitCode::bad_case) << text << answer.err;
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << text << answer.err;
  EXPECT_EQ(answer.out, "") << text;
  EXPECT_EQ(runs.files(), files) << text;
  return answer.err;
}

/// The line above a key: its table, or a comment where a key stands above all tables.
std::string head_of(const Key& key) {
  return key.table.empty() ? "# no table\n" : fmt::format("[{}]\n", key.table);
}

std::string case_with(const Key& key, const std::string& value) {
  return head_of(key) + fmt::format("{} = {}\n", key.name, value);
}

/// A value that is allowed, as it stands in a resolved case.
std::string good_value(const Key& key) {
  const std::string value = value_text(key, Case());
  return value.empty() ? "0.01" : value;
}

TEST(ReliableInput, AWrongValueOfAnyKeyIsNamed) {
  const Runs runs;
  std::size_t tried = 0;
  for (const Key& key : case_keys()) {
    for (const std::string& value : wrong_values(key)) {
      const std::string said = refusal_of(runs, case_with(key, value));
      EXPECT_THAT(said, HasSubstr(key.path())) << value;
      EXPECT_THAT(said, HasSubstr("bad.toml:2: ")) << key.path() << " = " << value;
      EXPECT_THAT(said, HasSubstr("allowed: ")) << key.path() << " = " << value;
      ++tried;
    }
  }
  std::cout << "wrong values tried: " << tried << " of " << case_keys().size() << " keys\n";
}

TEST(ReliableInput, AWrongValueOnTheCommandLineIsNamed) {
  const Runs runs;
  for (const Key& key : case_keys()) {
    for (const std::string& value : wrong_values(key)) {
      if (std::holds_alternative<std::monostate>(key.allowed)) continue;  // a bare word is a text there
      const Answer answer = runs.run("run", {key.path() + "=" + value});
      EXPECT_EQ(answer.code, ExitCode::bad_case) << key.path() << " = " << value << answer.err;
      EXPECT_THAT(answer.err, HasSubstr(key.path())) << value;
      EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
      EXPECT_EQ(runs.files(), 1u);
    }
  }
}

/// Every key: without a value, without "=", twice, in the wrong table, and with a letter too few.
TEST(ReliableInput, AnyKeyInTheWrongFormIsNamed) {
  const Runs runs;
  for (const Key& key : case_keys()) {
    const std::string name(key.name), table(key.table), good = good_value(key);
    const std::string line = name + " = " + good + "\n";
    const std::string head = head_of(key);
    EXPECT_THAT(refusal_of(runs, head + name + " =\n"), HasSubstr(key.path()));
    EXPECT_THAT(refusal_of(runs, head + name + "\n"), HasSubstr(name));
    EXPECT_THAT(refusal_of(runs, head + line + line), HasSubstr(key.path() + " = "));
    if (table.empty()) continue;
    EXPECT_THAT(refusal_of(runs, line), HasSubstr(name));
    EXPECT_THAT(refusal_of(runs, head + "[" + table + "." + name + "]\n"), HasSubstr(name));
    const std::string wrong = name.substr(0, name.size() - 1);
    if (find_key(table, wrong) || wrong.size() < 4) continue;
    EXPECT_THAT(refusal_of(runs, head + wrong + " = " + good + "\n"), HasSubstr(key.path()))
        << "the nearest key";
  }
}

TEST(ReliableInput, OddFilesAreRefused) {
  const Runs runs;
  for (const std::string& text :
       {std::string("[contact\n"), std::string("\0\0\0\0", 4), std::string("\xff\xfe[\0c\0", 6),
        std::string("= 1\n"), std::string("[contact]\nfriction = 0.1 0.2\n"), std::string(100'000, '['),
        std::string("a = \"") + std::string(100'000, 'b'),
        std::string("[contact]\n") + std::string(1000, 'x') + " = 1\n"})
    EXPECT_THAT(refusal_of(runs, text), testing::StartsWith("furnas: " + runs.path("bad.toml")));
}

/// Ends of lines and a byte-order mark of another system are no mistake.
TEST(ReliableInput, AFileOfAnotherSystemIsTheSame) {
  std::string text = resolved_toml({});
  std::string crlf = "\xef\xbb\xbf";
  for (const char letter : text) crlf += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  EXPECT_EQ(parse_case(crlf, "a"), parse_case(text, "a"));
}

}  // namespace
}  // namespace furnas
