/// Writes the measurements of a knob as JSON and reads them again; README.md lists the keys. Reading throws nlohmann::json
/// exceptions.
#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

[[nodiscard]] nlohmann::ordered_json error_json(const ErrorDistribution& error);
[[nodiscard]] ErrorDistribution error_of(const nlohmann::ordered_json& json);

/// Pictures are named by their files, without their bytes.
[[nodiscard]] nlohmann::ordered_json knob_json(const MeasuredKnob& knob);
[[nodiscard]] MeasuredKnob knob_from(const nlohmann::ordered_json& json);

}  // namespace tedavis::host_sim
