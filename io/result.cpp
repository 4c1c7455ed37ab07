#include "io/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/atomic_file.h"
#include "io/json_text.h"
#include "io/result_fields.h"

namespace furnas {
namespace {

using Json = nlohmann::ordered_json;  // writes NaN and infinity as null

/// The place of a field in the file: "stress.xx" in the object "stress".
Json& place_of(std::string_view name, Json& json) {
  const std::size_t dot = name.find('.');
  if (dot == name.npos) return json[std::string(name)];
  return json[std::string(name.substr(0, dot))][std::string(name.substr(dot + 1))];
}

}  // namespace

double Result::thickness() const {
  const Vec3<double> h = heights(measures.cell.edges);
  return std::min({h.x, h.y, h.z}) / sizes.largest;
}

std::optional<double> Result::phi_J() const {
  if (verdict != Verdict::jammed) return {};
  return measures.phi;
}

std::optional<double> Result::pace() const {
  if (!(wall_seconds > 0)) return {};
  return static_cast<double>(steps_here) * static_cast<double>(large + small) / wall_seconds / 1e6;
}

std::string thickness_text(double diameters) {
  return fmt::format("{:.1f}", diameters < least_thickness ? std::floor(10 * diameters) / 10 : diameters);
}

const char* remark_on_thickness(double diameters) {
  return diameters < least_thickness ? ": too thin to represent a large packing" : "";
}

void write_result(const Result& r, const Case& c, const std::filesystem::path& path) {
  Json json;
  for (const ResultField& field : result_fields()) place_of(field.about.name, json) = field.value(r, c);
  write_file(path, json_text(json));
}

}  // namespace furnas
