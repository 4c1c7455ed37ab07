#include "cases/program/command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <type_traits>
#include <utility>

#include "engine/base/numbers.h"

namespace furnas {
namespace {

/// A check of a number with a message about the allowed values. CLI11's own message prints the largest number
/// with all its digits.
CLI::Validator checked(bool (*holds)(double), const char* allowed) {
  return {[=](std::string& text) {
            const auto number = number_in<double>(text);
            return number && holds(*number) ? std::string() : text + "; allowed: " + allowed;
          },
          ""};
}

}  // namespace

Argument Argument::required() { return Argument(*option_->required()); }
Argument Argument::showing_default() { return Argument(*option_->capture_default_str()); }
Argument Argument::separated_by(char letter) { return Argument(*option_->delimiter(letter)); }
Argument Argument::above_zero() {
  return Argument(*option_->check(checked([](double x) { return x > 0; }, "a number above 0")));
}
Argument Argument::not_negative() {
  return Argument(*option_->check(checked([](double x) { return x >= 0; }, "0 or a number above it")));
}
Argument Argument::between(int least, int most) { return Argument(*option_->check(CLI::Range(least, most))); }
Argument Argument::between(double least, double most) {
  return Argument(*option_->check(CLI::Range(least, most)));
}
Argument Argument::one_of(const std::vector<std::string>& all) {
  return Argument(*option_->check(CLI::IsMember(all)));
}
Argument Argument::excludes(const Argument& other) { return Argument(*option_->excludes(other.option_)); }
Argument Argument::needs(const Argument& other) { return Argument(*option_->needs(other.option_)); }

namespace {

template <class T>
inline constexpr bool is_real = std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>> ||
                                std::is_same_v<T, std::vector<double>>;

/// The error of a word where a real number is needed. Empty if the word is a finite number, and also if it is
/// not a number, because CLI11 reports that.
std::string fault_of_real(const std::string& word) {
  const auto number = number_in<double>(word);
  return number && !std::isfinite(*number) ? word + " is not finite" : "";
}

}  // namespace

template <class T>
Argument CommandLine::add(const std::string& name, T& value, const std::string& does) {
  CLI::Option* option = app_->add_option(name, value, does);
  if constexpr (is_real<T>) option->check(CLI::Validator(fault_of_real, ""));
  return Argument(*option);
}

#define FURNAS_INSTANTIATE(T) \
  template Argument CommandLine::add<T>(const std::string&, T&, const std::string&);
FURNAS_INSTANTIATE(std::string)
FURNAS_INSTANTIATE(std::filesystem::path)
FURNAS_INSTANTIATE(int)
FURNAS_INSTANTIATE(std::int64_t)
FURNAS_INSTANTIATE(double)
FURNAS_INSTANTIATE(std::optional<int>)
FURNAS_INSTANTIATE(std::optional<std::int64_t>)
FURNAS_INSTANTIATE(std::optional<double>)
FURNAS_INSTANTIATE(std::vector<std::string>)
FURNAS_INSTANTIATE(std::vector<int>)
FURNAS_INSTANTIATE(std::vector<double>)
#undef FURNAS_INSTANTIATE

Argument CommandLine::flag(const std::string& name, bool& value, const std::string& does) {
  return Argument(*app_->add_flag(name, value, does));
}

Argument CommandLine::flag(const std::string& name, std::function<void()> then, const std::string& does) {
  return Argument(*app_->add_flag_callback(name, std::move(then), does));
}

CommandLine CommandLine::subcommand(const std::string& name, const std::string& does) {
  app_->require_subcommand(1);
  return CommandLine(*app_->add_subcommand(name, does));
}

bool CommandLine::parsed() const { return app_->parsed(); }

}  // namespace furnas
