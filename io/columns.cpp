#include "io/columns.h"

#include <fmt/format.h>

#include <algorithm>

namespace furnas {

void Columns::name(const TextReader& reader, std::vector<std::string> names) {
  std::vector<std::string> sorted = names;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    reader.fail(fmt::format("the column {} occurs twice", *twice));
  names_ = std::move(names);
}

void Columns::row(const TextReader& reader, std::vector<std::string_view> words) {
  reader_ = &reader;
  words_ = std::move(words);
  if (words_.size() != names_.size())
    reader.fail(fmt::format("{} columns; expected {}", words_.size(), names_.size()));
}

bool Columns::has_all(const std::vector<std::string>& names) const {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) { return has(name); });
}

double Columns::real(std::string_view name, double missing) const {
  const std::size_t k = find(name);
  return k == none ? missing : reader_->real(words_[k], name);
}

std::int64_t Columns::integer(std::string_view name, std::int64_t missing) const {
  const std::size_t k = find(name);
  return k == none ? missing : reader_->integer(words_[k], name);
}

std::int32_t Columns::type(std::string_view name) const {
  const std::size_t k = find(name);
  return k == none ? 0 : reader_->particle_type(words_[k]);
}

std::int32_t Columns::image(std::string_view name) const {
  const std::size_t k = find(name);
  return k == none ? 0 : reader_->image(words_[k]);
}

std::size_t Columns::find(std::string_view name) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  return at == names_.end() ? none : static_cast<std::size_t>(at - names_.begin());
}

}  // namespace furnas
