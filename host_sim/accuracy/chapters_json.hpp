/// Converts chapters of an AccuracyReport to JSON and back: the errors along a flight, the effects left out as invisible, the
/// governor's choice of quality levels, the negative control (a level that is wrong on purpose), and the comparison with an
/// earlier report. Knobs have their own functions (knob_json.hpp). The README.md of this folder lists the keys.
///
/// Reading throws exceptions of nlohmann::json for missing keys and wrong types. Names of unknown effects in `given_up`, and
/// levels beyond kQualityLevelCount, are skipped without an error.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

[[nodiscard]] nlohmann::ordered_json flight_json(const FlightErrors& flight);
[[nodiscard]] FlightErrors flight_from(const nlohmann::ordered_json& json);

/// A chapter that was not measured (nullopt) is a JSON null.
[[nodiscard]] nlohmann::ordered_json uncalled_json(const std::optional<UncalledEffects>& uncalled);
[[nodiscard]] std::optional<UncalledEffects> uncalled_from(const nlohmann::ordered_json& json);
[[nodiscard]] nlohmann::ordered_json governor_choice_json(const std::optional<GovernorChoice>& choice);
[[nodiscard]] std::optional<GovernorChoice> governor_choice_from(const nlohmann::ordered_json& json);
[[nodiscard]] nlohmann::ordered_json control_json(const std::optional<NegativeControl>& control);
[[nodiscard]] std::optional<NegativeControl> control_from(const nlohmann::ordered_json& json);

[[nodiscard]] nlohmann::ordered_json compared_json(const ComparedReport& compared);
[[nodiscard]] ComparedReport compared_from(const nlohmann::ordered_json& json);

}  // namespace tedavis::host_sim
