#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace furnas {

/// The text of a JSON file. Bytes that are not UTF-8, which a path may have, become U+FFFD.
inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace furnas
