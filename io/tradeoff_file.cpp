#include "io/tradeoff_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "engine/base/require.h"
#include "io/case_file.h"
#include "io/case_schema.h"
#include "io/case_table.h"
#include "io/case_value.h"
#include "io/case_words.h"

namespace furnas {
namespace {

constexpr int most_seeds = 100'000;
constexpr const char* own_tables[] = {tradeoff_table, "cases", "arms"};

/// Settings of the comparison, for one case or for all; an empty field was not given.
struct Terms {
  std::optional<int> samples;
  std::optional<double> margin;
  std::optional<std::string> reference;

  Terms with_defaults(const Terms& all) const {
    return {samples ? samples : all.samples, margin ? margin : all.margin,
            reference ? reference : all.reference};
  }
};

/// A table [cases.NAME] or [arms.NAME].
struct Entry {
  std::string name, place;
  Terms terms;                     ///< of a case
  std::vector<std::string> set;    ///< assignments, as in --set
  std::vector<std::string> cases;  ///< of an arm: the cases that it applies to; empty: all
  bool pressure_alone{};
};

class TradeoffReader {
 public:
  explicit TradeoffReader(const std::filesystem::path& file) : file_(file), root_(read_table(file)) {
    if (const toml::node* sweep = root_.get(sweep_table))
      throw InputError(fmt::format("{}: [{}] has no effect in a tradeoff; allowed: [cases.NAME], [arms.NAME]",
                                   place_of(*sweep), sweep_table));
    base_ = root_;
    for (const char* own : own_tables) base_.erase(own);
  }

  TradeoffFile read() {
    const Terms all = terms_of_all();
    const std::vector<Entry> cases = entries("cases"), arms = entries("arms");
    for (const Entry& arm : arms)
      for (const std::string& name : arm.cases)
        if (std::none_of(cases.begin(), cases.end(), [&](const Entry& c) { return c.name == name; }))
          throw InputError(fmt::format("{}: arms.{}.cases names \"{}\"; allowed: {}", arm.place, arm.name,
                                       name, names_of(cases)));
    TradeoffFile tradeoff;
    for (const Entry& c : cases)
      tradeoff.cases.push_back(case_with_arms(c, c.terms.with_defaults(all), arms));
    return tradeoff;
  }

 private:
  std::string place_of(const toml::node& node) const {
    return fmt::format("{}:{}", file_.string(), node.source().begin.line);
  }

  static std::string names_of(const std::vector<Entry>& entries) {
    std::string names;
    for (const Entry& e : entries) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", e.name);
    return names;
  }

  /// Takes samples, margin and reference; false for any other key.
  bool take_term(std::string_view key, const toml::node& node, Terms& terms) const {
    const auto refuse = [&](const char* allowed) {
      throw InputError(
          fmt::format("{}: {} = {}; allowed: {}", place_of(node), key, node_text(node), allowed));
    };
    if (key == "samples") {
      const auto samples = node.value_exact<std::int64_t>();
      if (!samples || *samples < 1 || *samples > most_seeds) refuse("an integer from 1 to 100000");
      terms.samples = static_cast<int>(*samples);
    } else if (key == "margin") {
      const auto margin = node.value_exact<double>();
      if (!margin || !(*margin > 0 && *margin < 1)) refuse("0 < margin < 1, a difference of phi");
      terms.margin = *margin;
    } else if (key == "reference") {
      terms.reference = node.value_exact<std::string>();
      if (!terms.reference) refuse("the name of an arm in quotes");
    } else {
      return false;
    }
    return true;
  }

  Terms terms_of_all() const {
    const toml::node* node = root_.get(tradeoff_table);
    const toml::table* table = node == nullptr ? nullptr : node->as_table();
    if (table == nullptr)
      throw InputError(
          fmt::format("{}: there is no [tradeoff] in it; allowed: a file with [tradeoff], [cases.NAME] and "
                      "[arms.NAME], as cases/tradeoff.toml",
                      file_.string()));
    Terms terms;
    for (const auto& [key, value] : *table)
      if (!take_term(key.str(), value, terms))
        throw InputError(fmt::format("{}: unknown key tradeoff.{} = {}; allowed: samples, margin, reference",
                                     place_of(value), key.str(), node_text(value)));
    return terms;
  }

  std::vector<Entry> entries(const char* kind) const {
    std::vector<std::pair<unsigned, Entry>> found;
    const toml::node* node = root_.get(kind);
    const toml::table* table = node == nullptr ? nullptr : node->as_table();
    if (table != nullptr)
      for (const auto& [name, value] : *table)
        found.emplace_back(value.source().begin.line, entry_of(kind, std::string(name.str()), value));
    if (found.empty()) throw InputError(fmt::format("{}: there is no [{}.NAME] in it", file_.string(), kind));
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Entry> in_order;
    in_order.reserve(found.size());
    for (auto& [line, entry] : found) in_order.push_back(std::move(entry));
    return in_order;
  }

  Entry entry_of(std::string_view kind, std::string name, const toml::node& node) const {
    Entry entry{std::move(name), place_of(node), {}, {}, {}, false};
    const bool fit = !entry.name.empty() && entry.name.front() != '.' &&
                     std::all_of(entry.name.begin(), entry.name.end(), [](unsigned char c) {
                       return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '+' || c == '-';
                     });
    if (!fit || !node.is_table())
      throw InputError(
          fmt::format("{}: {}.\"{}\" is not a table, or not a name for a folder; allowed: [{}.NAME], "
                      "NAME of letters, digits and \"._+-\"",
                      entry.place, kind, entry.name, kind));
    std::size_t pressures = 0;
    for (const auto& [key, value] : *node.as_table()) {
      if (kind == "cases" && take_term(key.str(), value, entry.terms)) continue;
      if (kind == "arms" && key.str() == "cases") {
        entry.cases = names_in(value);
        continue;
      }
      entry.set.push_back(assignment_of(kind, entry.name, std::string(key.str()), value));
      if (key.str() == "compaction.pressure" && !value.is_array()) ++pressures;
    }
    entry.pressure_alone = pressures == 1 && entry.set.size() == 1;
    return entry;
  }

  std::vector<std::string> names_in(const toml::node& node) const {
    std::vector<std::string> names;
    if (const toml::array* list = node.as_array())
      for (const toml::node& name : *list)
        if (const auto text = name.value_exact<std::string>()) names.push_back(*text);
    if (names.empty() || names.size() != node.as_array()->size())
      throw InputError(fmt::format("{}: cases = {}; allowed: a list of names of cases in quotes",
                                   place_of(node), node_text(node)));
    return names;
  }

  std::string assignment_of(std::string_view kind, const std::string& name, const std::string& path,
                            const toml::node& node) const {
    const Key* key = find_key(path);
    if (key == nullptr || path == "mixture.seed") {
      const std::size_t dot = path.find('.');
      const std::string nearest =
          nearest_key(path.substr(0, dot), dot == path.npos ? "" : path.substr(dot + 1));
      throw InputError(
          fmt::format("{}: unknown key {}.{}.\"{}\" = {}; allowed: keys of the case in quotes, like \"{}\"; "
                      "seeds are taken from the samples",
                      place_of(node), kind, name, path, node_text(node),
                      nearest.empty() || path == "mixture.seed" ? "contact.friction" : nearest));
    }
    Case c;
    assign(*key, node, c, place_of(node));
    return path + "=" + value_text(*key, c);
  }

  TradeoffCase case_with_arms(const Entry& entry, const Terms& terms, const std::vector<Entry>& arms) const {
    const auto must = [&](bool given, const char* what) {
      if (!given)
        throw InputError(fmt::format("{}: cases.{} has no {}; allowed: {} in [tradeoff] or in [cases.{}]",
                                     entry.place, entry.name, what, what, entry.name));
    };
    must(terms.samples.has_value(), "samples");
    must(terms.margin.has_value(), "margin");
    must(terms.reference.has_value(), "reference");
    TradeoffCase c{entry.name, *terms.reference, *terms.samples, *terms.margin, {}, entry.set};
    std::map<std::string, std::string> known;
    for (const Entry& arm : arms) {
      if (!arm.cases.empty() && std::find(arm.cases.begin(), arm.cases.end(), c.name) == arm.cases.end())
        continue;
      c.arms.push_back({arm.name, case_of(entry, arm), arm.pressure_alone, arm.set});
      const auto [same, fresh] = known.emplace(resolved_toml(c.arms.back().c), arm.name);
      if (!fresh)
        throw InputError(
            fmt::format("{}: arms.{} and arms.{} are one and the same case for cases.{}; allowed: one of "
                        "them (cases = [...] limits an arm to some cases)",
                        arm.place, same->second, arm.name, c.name));
    }
    if (std::none_of(c.arms.begin(), c.arms.end(), [&](const auto& a) { return a.name == c.reference; }))
      throw InputError(fmt::format("{}: reference = \"{}\" is no arm of cases.{}; allowed: one of its arms",
                                   entry.place, c.reference, c.name));
    return c;
  }

  Case case_of(const Entry& entry, const Entry& arm) const {
    std::vector<std::string> set = entry.set;
    set.insert(set.end(), arm.set.begin(), arm.set.end());
    try {
      Case c = case_in(base_, file_, set);
      if (!c.start.file.empty())
        throw InputError(fmt::format(
            "start.file = \"{}\" gives the same start for every seed; allowed: [mixture]", c.start.file));
      return c;
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: cases.{} with arms.{}: {}", arm.place, entry.name, arm.name, error.what()));
    }
  }

  std::filesystem::path file_;
  toml::table root_, base_;
};

}  // namespace

TradeoffFile read_tradeoff(const std::filesystem::path& file) { return TradeoffReader(file).read(); }

}  // namespace furnas
