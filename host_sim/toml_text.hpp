/// JSON as TOML, for designs and the like: objects are tables, lists of objects are lists of tables.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tedavis::host_sim {

/// Numbers are written with as many digits as give the same double when they are read. A list must contain objects alone or none;
/// null is not allowed, as in TOML.
[[nodiscard]] std::string toml_text(const nlohmann::ordered_json& table);

/// A basic string of TOML in its quotes; the text may hold any byte but 0.
[[nodiscard]] std::string toml_string(const std::string& text);

}  // namespace tedavis::host_sim
