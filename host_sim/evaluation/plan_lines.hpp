/// Describes a frame's plan in words, from its record.
#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/evaluation/evaluated_flight.hpp"

namespace tedavis::host_sim {

/// Returns the description of a record, which is a line of `frames.jsonl`; members that it lacks are left out.
[[nodiscard]] PlanLines plan_lines(const nlohmann::ordered_json& record);

}  // namespace tedavis::host_sim
