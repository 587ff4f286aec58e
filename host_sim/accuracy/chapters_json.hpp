/// Writes the chapters of a report, except its knobs, as JSON, and reads them again. The README.md of this folder lists the keys.
/// Reading throws exceptions of nlohmann::json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

[[nodiscard]] nlohmann::ordered_json flight_json(const FlightErrors& flight);
[[nodiscard]] FlightErrors flight_from(const nlohmann::ordered_json& json);

/// Null for what was not measured.
[[nodiscard]] nlohmann::ordered_json uncalled_json(const std::optional<UncalledEffects>& uncalled);
[[nodiscard]] std::optional<UncalledEffects> uncalled_from(const nlohmann::ordered_json& json);
[[nodiscard]] nlohmann::ordered_json governor_choice_json(const std::optional<GovernorChoice>& choice);
[[nodiscard]] std::optional<GovernorChoice> governor_choice_from(const nlohmann::ordered_json& json);
[[nodiscard]] nlohmann::ordered_json control_json(const std::optional<NegativeControl>& control);
[[nodiscard]] std::optional<NegativeControl> control_from(const nlohmann::ordered_json& json);

[[nodiscard]] nlohmann::ordered_json compared_json(const ComparedReport& compared);
[[nodiscard]] ComparedReport compared_from(const nlohmann::ordered_json& json);

}  // namespace tedavis::host_sim
