#include "cases/program/command_line.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <utility>

namespace furnas {

Argument Argument::required() { return Argument(*option_->required()); }
Argument Argument::showing_default() { return Argument(*option_->capture_default_str()); }
Argument Argument::separated_by(char letter) { return Argument(*option_->delimiter(letter)); }
Argument Argument::above_zero() { return Argument(*option_->check(CLI::PositiveNumber)); }
Argument Argument::not_negative() { return Argument(*option_->check(CLI::NonNegativeNumber)); }
Argument Argument::between(int least, int most) { return Argument(*option_->check(CLI::Range(least, most))); }
Argument Argument::between(double least, double most) {
  return Argument(*option_->check(CLI::Range(least, most)));
}
Argument Argument::one_of(const std::vector<std::string>& all) {
  return Argument(*option_->check(CLI::IsMember(all)));
}
Argument Argument::excludes(const Argument& other) { return Argument(*option_->excludes(other.option_)); }
Argument Argument::needs(const Argument& other) { return Argument(*option_->needs(other.option_)); }

template <class T>
Argument CommandLine::add(const std::string& name, T& value, const std::string& does) {
  return Argument(*app_->add_option(name, value, does));
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
