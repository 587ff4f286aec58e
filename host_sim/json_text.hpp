/// Converts JSON to text; bytes that are not valid UTF-8 are replaced, since names come from files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tedavis::host_sim {

/// `indent` below 0: one line.
template <class Json>
[[nodiscard]] std::string json_text(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tedavis::host_sim
