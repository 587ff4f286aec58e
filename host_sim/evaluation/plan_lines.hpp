/// Describes a frame's plan in words, from its record.
#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/evaluation/evaluated_flight.hpp"

namespace tedavis::host_sim {

/// Of a line of `frames.jsonl`; what the record lacks is left out.
[[nodiscard]] PlanLines plan_lines(const nlohmann::ordered_json& record);

}  // namespace tedavis::host_sim
