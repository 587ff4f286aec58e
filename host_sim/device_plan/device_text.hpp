/// A device as a file, and a plan as JSON. Pure; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host_sim/device_plan/device_plan.hpp"

namespace tedavis::host_sim {

/// Returns a device file (configs/devices) that reads back as the same device, without costs. `comment` is the text of its first
/// lines, without comment marks.
[[nodiscard]] std::string device_text(const effects::DeviceSettings& device, const std::string& comment);

/// Returns a plan as JSON; `memory_bytes` is the memory for which it was made.
[[nodiscard]] nlohmann::ordered_json plan_json(const DevicePlan& plan, std::uint64_t memory_bytes);
/// Returns it in some lines for the user.
[[nodiscard]] std::string plan_text(const DevicePlan& plan, std::uint64_t memory_bytes);

}  // namespace tedavis::host_sim
